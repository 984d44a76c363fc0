// SPDX-License-Identifier: GPL-3.0-or-later
// What the menu Help gives: the manual at the right place, explanations, and the report for somebody who helps.
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QHelpEvent>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMovie>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QThread>
#include <QToolBar>
#include <QWhatsThis>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/window/command_palette.h"
#include "app/window/help_pages.h"
#include "app/window/language.h"
#include "app/window/stalls.h"
#include "croquis/document/content_hash.h"
#include "croquis/io/project_file.h"
#include "croquis/tools/all_steps.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// The sections of a file of the manual by their headings, in their order.
QList<std::pair<QString, QString>> sections_of(const char* path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  QList<std::pair<QString, QString>> sections;
  for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
    if (line.startsWith("##"))
      sections.append({line.section(' ', 1), {}});
    else if (!sections.isEmpty())
      sections.back().second += line + '\n';
  }
  return sections;
}

/// @param own the manual in the language in use
void check_sections(app::MainWindow& window, const QList<std::pair<QString, QString>>& own) {
  const auto english = sections_of(CROQUIS_SOURCE_DIR "/docs/studio.md");
  REQUIRE(english.size() == own.size());
  for (const QAction* action : window.actions()) {
    if (app::plain_text(*action).isEmpty()) continue;
    INFO(action->objectName().toStdString());
    const app::HelpPlace place = app::help_place_of(*action);
    INFO(place.heading.toStdString() << ": " << place.words.toStdString());
    QString section;
    for (int i = 0; i < own.size(); ++i) {
      if (english[i].first == place.heading) section = own[i].second;
    }
    CHECK(section.remove('*').simplified().contains(place.words));
    const QStringList names = app::menu_place(*action).split(" ▸ ") + QStringList{app::plain_text(*action)};
    CHECK(!place.words.isEmpty());
    CHECK(names.contains(place.words));
  }
}

QJsonObject json_of(const QByteArray& text) { return QJsonDocument::fromJson(text).object(); }

QDialog* report_dialog(StudioFixture& hand) {
  hand.act("help-report");
  auto* dialog = hand.window().findChild<QDialog*>("report");
  REQUIRE(dialog != nullptr);
  return dialog;
}

}  // namespace

TEST_CASE("every action has a section of the manual that names it or its menu, in each language", "[help]") {
  {
    StudioFixture hand;
    check_sections(hand.window(), sections_of(CROQUIS_SOURCE_DIR "/docs/studio.md"));
  }
  QSettings().setValue("language", "ko");
  app::use_language("ko");
  {
    StudioFixture hand;
    check_sections(hand.window(), sections_of(CROQUIS_SOURCE_DIR "/docs/ko/studio.md"));
  }
  app::use_language("en");
  QSettings().remove("language");
}

TEST_CASE("Shift+F1 explains whatever is clicked, F1 opens the manual at it", "[help]") {
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("help-whats-this");
  CHECK(QWhatsThis::inWhatsThisMode());
  QWhatsThis::leaveWhatsThisMode();
  for (const QAction* action : hand.window().actions()) {
    if (!app::plain_text(*action).isEmpty())
      CHECK(action->whatsThis().contains(app::plain_text(*action).toHtmlEscaped()));
  }
  int explained = 0;
  for (const auto* dock : hand.window().findChildren<QDockWidget*>()) {
    for (const QWidget* widget : dock->findChildren<QWidget*>()) {
      CHECK(!widget->whatsThis().isEmpty());
      if (widget->toolTip().isEmpty() || widget->inherits("QToolButton")) continue;
      ++explained;
      CHECK(widget->whatsThis().contains(widget->toolTip().toHtmlEscaped()));
    }
  }
  CHECK(explained > 5);
  // The pointer is on a panel.
  auto* panel = hand.window().findChild<QDockWidget*>("edges-dock");
  REQUIRE(panel != nullptr);
  panel->raise();
  hand.settle();
  QCursor::setPos(panel->widget()->mapToGlobal(panel->widget()->rect().center()));
  REQUIRE(hand.wait_for([&] { return QApplication::widgetAt(QCursor::pos()) != nullptr; }));
  hand.act("help");
  const auto* page = hand.window().findChild<QDialog*>("manual")->findChild<QTextBrowser*>();
  CHECK(page->textCursor().block().text().contains("The panel Sharp edges has"));
}

TEST_CASE("the buttons of tools show the tool at work while the pointer is on them", "[help]") {
  StudioFixture hand;
  hand.act("new-surface");
  auto* shown = hand.window().findChild<QWidget*>("tool-movie");
  REQUIRE(shown != nullptr);
  for (const char* tool : {"draw", "tube", "erase", "select", "move", "rotate", "scale", "sharpen", "holes", "measure",
                           "patch", "surface-point", "inner-curve"}) {
    INFO(tool);
    QWidget* button = hand.window().findChild<QToolBar*>("tools")->widgetForAction(hand.window().action(tool));
    REQUIRE(button != nullptr);
    QHelpEvent asks(QEvent::ToolTip, QPoint(3, 3), button->mapToGlobal(QPoint(3, 3)));
    QApplication::sendEvent(button, &asks);
    CHECK(shown->isVisible());
    CHECK(hand.window().screen()->availableGeometry().contains(shown->geometry()));
    CHECK(!shown->geometry().contains(button->mapToGlobal(QPoint(3, 3))));
    const auto labels = shown->findChildren<QLabel*>();
    REQUIRE(labels.size() == 2);
    CHECK(labels.front()->text() == hand.window().action(tool)->toolTip());
    QMovie* movie = labels.back()->movie();
    REQUIRE(movie->isValid());
    CHECK(movie->frameCount() >= 20);
    CHECK(movie->frameCount() * movie->nextFrameDelay() <= 13'000);
    const QImage first = movie->currentImage();
    for (int frame = 0; frame < movie->frameCount() * 2 / 3; ++frame) movie->jumpToNextFrame();
    CHECK(movie->currentImage() != first);
    QEvent leaves(QEvent::Leave);
    QApplication::sendEvent(button, &leaves);
    CHECK(!shown->isVisible());
    CHECK(movie->state() == QMovie::NotRunning);
  }
}

TEST_CASE("a report has what helps, and names and shapes only where that is ticked", "[help]") {
  StudioFixture hand;
  hand.draw(linked_rings_sketch());
  hand.settle();
  const ContentHash drawn = content_hash(hand.studio().session().document());
  QSettings().setValue("recent", QStringList{"/home/somebody/secret.croq"});
  QDialog* dialog = report_dialog(hand);
  CHECK(!dialog->findChild<QCheckBox*>("report-document")->isChecked());
  dialog->findChild<QCheckBox*>("report-steps")->setChecked(false);
  dialog->findChild<QPushButton*>("report-copy")->click();
  const QJsonObject small = json_of(QGuiApplication::clipboard()->text().toUtf8());
  CHECK(small["qt"].toString().contains(qVersion()));
  CHECK(!small["graphics"].toString().isEmpty());
  CHECK(small["graphics"].toString() != "unknown");
  CHECK(small["objects"].toArray().size() == static_cast<qsizetype>(hand.studio().objects().size()));
  CHECK(!QGuiApplication::clipboard()->text().contains("secret"));
  QSettings().remove("recent");
  CHECK(!small.contains("steps"));
  CHECK(!small.contains("document"));
  if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
    dialog->grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/report.png");

  const QString path = hand.folder() + "/report.json";
  dialog->findChild<QCheckBox*>("report-steps")->setChecked(true);
  dialog->findChild<QCheckBox*>("report-document")->setChecked(true);
  dialog->findChild<QLineEdit*>("report-path")->setText(path);
  emit dialog->findChild<QDialogButtonBox*>()->accepted();
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QJsonObject whole = json_of(file.readAll());
  std::string recording;
  for (const QJsonValue line : whole["steps"].toArray()) recording += line.toString().toStdString() + '\n';
  const auto lines = recorded::parse(recording, "report", recorded::all_steps());
  CHECK(lines.size() >= linked_rings_sketch().drawing.strokes.size());
  const QString project = hand.folder() + "/report.croq";
  QFile copy(project);
  REQUIRE(copy.open(QIODevice::WriteOnly));
  copy.write(QByteArray::fromBase64(whole["document"].toString().toLatin1()));
  copy.close();
  Progress progress;
  CHECK(content_hash(load_project(project.toStdString(), progress).document) == drawn);

  // A file that can't be written is said, and the dialog stays.
  dialog = report_dialog(hand);
  dialog->findChild<QLineEdit*>("report-path")->setText(hand.folder() + "/missing/report.json");
  emit dialog->findChild<QDialogButtonBox*>()->accepted();
  CHECK(dialog->isVisible());
  CHECK(hand.window().last_findings().front().code == "E_WRITE");
  hand.window().set_unattended();
  hand.act("new");
  CHECK(hand.window().parts().steps.size() == 1);
}

TEST_CASE("times without events are noted with what ran", "[help]") {
  app::StallWatch watch;
  watch.note("testing");
  QObject receiver;
  QApplication::processEvents();
  QMetaObject::invokeMethod(
      &receiver, [] { QThread::msleep(60); }, Qt::QueuedConnection);
  QApplication::processEvents();
  QTest::qWait(60);  // waiting for events is no stall
  QApplication::processEvents();
  REQUIRE(!watch.longest().empty());
  const app::Stall& stall = watch.longest().front();
  CHECK(stall.ms >= 60);
  CHECK(stall.longest_ms >= 60);
  CHECK(stall.what == "QObject MetaCall");
  CHECK(stall.after == "testing");
  for (int i = 0; i < 12; ++i) {
    QMetaObject::invokeMethod(
        &receiver, [] { QThread::msleep(25); }, Qt::QueuedConnection);
    QApplication::processEvents();
  }
  CHECK(watch.longest().size() == 10);
  CHECK(std::ranges::is_sorted(watch.longest(), std::greater<>(), &app::Stall::ms));
}
