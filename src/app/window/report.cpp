// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/report.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDateTime>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/main_window.h"
#include "croquis/io/project_file.h"

namespace croquis::app {
namespace {

constexpr int report_width = 560;

QJsonArray sizes_of_objects(const Studio& studio) {
  QJsonArray all;
  for (const WorkObject& object : studio.objects()) {
    QJsonArray chain;
    for (const NodeId id : object.chain) {
      const Node* node = studio.session().document().find(id);
      if (node != nullptr) chain.append(QString::fromStdString(node->operation.empty() ? "source" : node->operation));
    }
    const auto mesh = object.shown();
    all.append(QJsonObject{{"steps", chain},
                           {"vertices", static_cast<qint64>(mesh ? mesh->vertex_count() : 0)},
                           {"faces", static_cast<qint64>(mesh ? mesh->face_count() : 0)}});
  }
  return all;
}

/// @param sentences name files, objects and strokes
QJsonArray texts_of_findings(MainWindow& window, bool sentences) {
  Findings all = window.last_findings();
  for (const NodeFinding& found : findings_of(window.studio())) all.push_back(found.finding);
  QJsonArray texts;
  for (const Finding& finding : all)
    texts.append(QString::fromStdString(finding.code + (sentences ? ": " + finding.message : std::string())));
  return texts;
}

QString project_of(const Document& document) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("report.croq"));
  Progress progress;
  ProjectFile project;
  project.document = document;
  save_project(QFile::encodeName(file.fileName()).toStdString(), project, progress);
  return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readAll().toBase64()) : QString();
}

QByteArray text_of_report(MainWindow& window, const ReportParts& parts) {
  return QJsonDocument(report_of(window, parts)).toJson();
}

QString proposed_report() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  return QDir(QDir(documents).exists() ? documents : QDir::homePath()).filePath("croquis-report-" + time + ".json");
}

bool write_report(MainWindow& window, const QString& path, const ReportParts& parts) {
  return window.attempt([&] {
    const QByteArray text = text_of_report(window, parts);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.flush())
      throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
    window.parts().help->say_written(path, QObject::tr("Wrote %1: attach it where you ask for help").arg(path));
  });
}

}  // namespace

QJsonObject report_of(MainWindow& window, const ReportParts& parts) {
  const QSettings settings;
  QJsonObject kept;
  for (const QString& key : settings.allKeys()) {
    const bool names_files = key == QLatin1String("recent");
    if (!names_files) kept[key] = QJsonValue::fromVariant(settings.value(key));
  }
  QJsonObject report{{"croquis", QCoreApplication::applicationVersion()},
                     {"qt", QStringLiteral("%1, %2").arg(qVersion(), QGuiApplication::platformName())},
                     {"system", QSysInfo::prettyProductName()},
                     {"graphics", window.viewport().graphics()},
                     {"window", QStringLiteral("%1 x %2").arg(window.width()).arg(window.height())},
                     {"scale", window.devicePixelRatioF()},
                     {"settings", kept},
                     {"objects", sizes_of_objects(window.studio())},
                     {"findings", texts_of_findings(window, parts.steps)},
                     {"stalls", to_json(window.parts().stalls.longest())}};
  if (parts.steps) {
    QJsonArray steps;
    for (const recorded::Step& step : window.parts().steps)
      steps.append(QString::fromStdString(recorded::to_line(step)));
    report["steps"] = steps;
  }
  if (parts.document) report["document"] = project_of(window.studio().session().document());
  return report;
}

void ask_report(MainWindow& window) {
  delete window.findChild<QDialog*>("report");
  auto* dialog = new QDialog(&window);
  dialog->setObjectName("report");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Report a problem"));
  auto* column = new QVBoxLayout(dialog);
  auto* about = new QLabel(
      QObject::tr("The report is one text file. It has the versions of Croquis and the system, the graphics card, the "
                  "window's settings, the number of vertices and faces of each object, kinds of findings, and when the "
                  "window was slow. Nothing is sent: attach the file where you ask for help."),
      dialog);
  about->setWordWrap(true);
  about->setMinimumWidth(report_width);
  column->addWidget(about);
  const auto add_box = [&](const char* name, const QString& text, bool checked) {
    auto* box = new QCheckBox(text, dialog);
    box->setObjectName(name);
    box->setChecked(checked);
    column->addWidget(box);
    return box;
  };
  auto* steps = add_box(
      "report-steps",
      QObject::tr("With the strokes and commands since the document was opened, and the sentences of findings"), true);
  auto* document = add_box("report-document", QObject::tr("With the document"), false);
  auto* path = new QLineEdit(QDir::toNativeSeparators(proposed_report()), dialog);
  path->setObjectName("report-path");
  column->addWidget(new QLabel(QObject::tr("It will be written to:"), dialog));
  column->addWidget(path);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, dialog);
  auto* copy = buttons->addButton(QObject::tr("Copy"), QDialogButtonBox::ActionRole);
  copy->setObjectName("report-copy");
  column->addWidget(buttons);
  const auto wanted = [steps, document] { return ReportParts{steps->isChecked(), document->isChecked()}; };
  QObject::connect(copy, &QPushButton::clicked, dialog, [&window, wanted] {
    window.attempt([&] { QApplication::clipboard()->setText(text_of_report(window, wanted())); });
  });
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, [&window, dialog, path, wanted] {
    if (write_report(window, QDir::fromNativeSeparators(path->text()), wanted())) dialog->close();
  });
  dialog->open();
}

}  // namespace croquis::app
