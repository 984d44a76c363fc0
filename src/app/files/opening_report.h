// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

#include "croquis/base/finding.h"

namespace croquis::app {

/// The findings of a file as lines for people: each a sentence with its stop, the file named without its folders.
QStringList sentences_of(const Findings& findings, const QString& path);

/// What was wrong with a project that was opened, every finding of it, and the earlier versions beside it.
class OpeningReport : public QDialog {
  Q_OBJECT

 public:
  OpeningReport(const QString& path, const Findings& findings, QWidget* parent);

 signals:
  void version_wanted(const QString& path);

 private:
  QString headline(const Findings& findings) const;
  QWidget* make_versions();

  QString path_;
};

}  // namespace croquis::app
