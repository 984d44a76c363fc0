// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening_report.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/window/theme.h"
#include "croquis/io/project_file.h"

namespace croquis::app {
namespace {

constexpr QSize report_size(560, 380);

QString when_written(const QString& path) {
  return QLocale().toString(QFileInfo(path).lastModified().toLocalTime(), QLocale::ShortFormat);
}

}  // namespace

QStringList sentences_of(const Findings& findings, const QString& path) {
  QStringList lines;
  for (const Finding& finding : findings) {
    QString sentence = QString::fromStdString(finding.message);
    if (!path.isEmpty()) sentence.replace(path, QFileInfo(path).fileName());
    lines << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return lines;
}

OpeningReport::OpeningReport(const QString& path, const Findings& findings, QWidget* parent)
    : QDialog(parent), path_(path) {
  setObjectName("opening-report");
  setWindowTitle(QFileInfo(path).fileName());
  setAttribute(Qt::WA_DeleteOnClose);
  resize(report_size);
  auto* column = new QVBoxLayout(this);
  auto* head = new QLabel(headline(findings), this);
  head->setObjectName("opening-headline");
  head->setWordWrap(true);
  column->addWidget(head);
  auto* list = new QListWidget(this);
  list->setObjectName("opening-findings");
  list->setWordWrap(true);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const QStringList lines = sentences_of(findings, path);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    auto* row = new QListWidgetItem(lines[i], list);
    const Finding& finding = findings[static_cast<std::size_t>(i)];
    row->setForeground(sentence_color(finding.severity));
    row->setToolTip(QString::fromStdString(finding.code));
  }
  column->addWidget(list, 1);
  column->addWidget(make_versions());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QString OpeningReport::headline(const Findings& findings) const {
  const QString name = QFileInfo(path_).fileName();
  if (has_errors(findings)) return tr("%1 can't be opened. What was open before is still there.").arg(name);
  return tr("%1 is damaged, and what is named below is lost. The file stays as it is: saving asks for another name.")
      .arg(name);
}

/// Its earlier versions; of one of these, the others.
QWidget* OpeningReport::make_versions() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  const std::string file = QFile::encodeName(path_).toStdString();
  int shown = 0;
  for (const auto& version : project_backups(project_of_backup(file).value_or(file))) {
    const QString path = QFile::decodeName(QByteArray::fromStdString(version.string()));
    if (QFileInfo(path) == QFileInfo(path_)) continue;
    if (shown++ == 0) column->addWidget(new QLabel(tr("Earlier versions, as they were saved:"), box));
    auto* button = new QPushButton(tr("Open %1, of %2").arg(QFileInfo(path).fileName(), when_written(path)), box);
    button->setObjectName("version-" + QString::number(shown));
    connect(button, &QPushButton::clicked, this, [this, path] {
      accept();
      emit version_wanted(path);
    });
    column->addWidget(button, 0, Qt::AlignLeft);
  }
  if (shown == 0) column->addWidget(new QLabel(tr("No earlier versions lie beside it."), box));
  return box;
}

}  // namespace croquis::app
