// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/step_export.h"

#include <QFile>
#include <QMetaObject>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/io/file.h"

namespace croquis::app {

StepExport::StepExport() { thread_.setMaxThreadCount(1); }

StepExport::~StepExport() {
  cancel();
  thread_.waitForDone();
}

void StepExport::start(std::shared_ptr<const Brep> solid, StepOptions options, const QString& path) {
  if (busy_) return;
  busy_ = true;
  *cancelled_ = false;
  emit busy_changed(true);
  thread_.start([this, solid = std::move(solid), options = std::move(options), path, cancelled = cancelled_] {
    Progress progress(
        [this](double fraction, const std::string& step) {
          const QString text = QString::fromStdString(step);
          QMetaObject::invokeMethod(
              this, [this, fraction, text] { emit progress_changed(fraction, text); }, Qt::QueuedConnection);
        },
        cancelled.get());
    bool written = false;
    Findings findings;
    try {
      StepFile file = write_step(*solid, options, progress);
      OutputTransaction files;
      files.add(QFile::encodeName(path).toStdString(), std::move(file.bytes));
      files.commit();
      written = true;
    } catch (const Error& error) {
      findings = error.findings();
    } catch (const Cancelled&) {
      written = false;
    } catch (const std::bad_alloc&) {
      findings = {make_error(Category::Limit, "E_MEMORY", "The solid doesn't fit into this machine's memory.")};
    }
    QMetaObject::invokeMethod(
        this, [this, path, written, findings] { take(path, written, findings); }, Qt::QueuedConnection);
  });
}

void StepExport::take(const QString& path, bool written, const Findings& findings) {
  busy_ = false;
  emit busy_changed(false);
  if (written)
    emit finished(path);
  else
    emit failed(findings);
}

}  // namespace croquis::app
