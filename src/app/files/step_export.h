// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <atomic>
#include <memory>

#include "croquis/base/finding.h"
#include "croquis/geometry/brep.h"
#include "step/step_file.h"

namespace croquis::app {

/// Writes a solid as a STEP file on another thread, one at a time.
class StepExport : public QObject {
  Q_OBJECT

 public:
  StepExport();
  ~StepExport() override;

  /// Nothing while one is being written.
  void start(std::shared_ptr<const Brep> solid, StepOptions options, const QString& path);

  /// Nothing is written then.
  void cancel() { *cancelled_ = true; }

  bool busy() const { return busy_; }

 signals:
  void finished(const QString& path);
  void failed(const croquis::Findings& findings);  ///< none: it was cancelled
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 private:
  void take(const QString& path, bool written, const Findings& findings);

  bool busy_ = false;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  QThreadPool thread_;
};

}  // namespace croquis::app
