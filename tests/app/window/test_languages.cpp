// SPDX-License-Identifier: GPL-3.0-or-later
// The window in Korean, changed while it is open.
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTextBlock>
#include <QTextBrowser>
#include <map>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/panels/attribute_panel.h"
#include "app/window/command_palette.h"
#include "app/window/help_pages.h"
#include "app/window/language.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Takes the language back, whatever a test does.
class Speaking {
 public:
  explicit Speaking(StudioFixture& hand) : hand_(hand) {}
  ~Speaking() { choose("en"); }

  /// As people do it.
  void choose(const QString& code) {
    hand_.act("preferences");
    auto* dialog = hand_.window().findChild<QDialog*>("preferences");
    auto* field = dialog->findChild<QComboBox*>("language");
    field->setCurrentIndex(field->findData(code));
    if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
      dialog->grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/preferences-" + code + ".png");
    delete dialog;
  }

 private:
  StudioFixture& hand_;
};

bool is_korean(const QString& text) {
  static const QRegularExpression hangul(QStringLiteral("[\\x{ac00}-\\x{d7a3}]"));
  return hangul.match(text).hasMatch();
}

/// Names that are the same everywhere.
bool is_a_name(const QString& text) {
  static const QRegularExpression names(
      QStringLiteral("^(mm|cm|m|in|Camera of .*|Maya|Blender|CAD|English|STEP|[^A-Za-z]*)$"));
  return names.match(text).hasMatch();
}

/// What stands still in the window: by the widget's or action's address, its text.
std::map<const QObject*, QString> standing_texts(StudioFixture& hand) {
  std::map<const QObject*, QString> texts;
  for (const QAction* action : hand.window().actions()) texts[action] = app::plain_text(*action);
  for (const auto* dock : hand.window().findChildren<QDockWidget*>()) texts[dock] = dock->windowTitle();
  for (const QAction* menu : hand.window().menuBar()->actions()) texts[menu] = app::plain_text(*menu);
  return texts;
}

}  // namespace

TEST_CASE("the language changes while the window is open, there and back", "[languages]") {
  StudioFixture hand;
  hand.window().set_unattended();
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  const auto english = standing_texts(hand);
  Speaking speaking(hand);
  speaking.choose("ko");
  for (const auto& [object, text] : standing_texts(hand)) {
    INFO(english.at(object).toStdString() << ": " << text.toStdString());
    CHECK((is_korean(text) || is_a_name(text)));
  }
  const auto* panel = hand.window().findChild<app::AttributePanel*>();
  for (const QLabel* label : panel->findChildren<QLabel*>()) {
    INFO(label->text().toStdString());
    CHECK((is_korean(label->text()) || is_a_name(label->text())));
  }
  if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
    hand.window().grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/window-ko.png");
  // The manual opens at the tool in hand.
  const QStringList korean = app::manual_headings();
  hand.act("edge-mode");
  hand.act("help");
  const auto* manual = hand.window().findChild<QDialog*>("manual");
  REQUIRE(manual != nullptr);
  const QString opened = manual->findChild<QTextBrowser*>()->textCursor().block().text();
  CHECK(is_korean(opened));
  CHECK(korean.contains(opened));
  delete manual;
  // Commands are found by either name.
  const auto commands = app::all_commands(hand.window());
  for (const char* typed : {"loop cut", "루프 컷"}) {
    const auto found = app::found_commands(commands, typed);
    REQUIRE(!found.empty());
    CHECK(commands[found.front()].text == "루프 컷");
  }
  speaking.choose("en");
  const QStringList sections = app::manual_headings();
  CHECK(sections.size() == korean.size());
  CHECK(sections.indexOf("Meshes") == korean.indexOf(opened));
  for (const auto& [object, text] : standing_texts(hand)) CHECK(text.toStdString() == english.at(object).toStdString());
}

TEST_CASE("a window that opens in Korean shows no English words", "[languages]") {
  QSettings().setValue("language", "ko");
  CHECK(app::kept_language() == "ko");
  app::use_language("ko");
  {
    StudioFixture hand;
    hand.window().set_unattended();
    const auto check = [&](const char* state) {
      hand.settle();
      for (const QWidget* widget : hand.window().findChildren<QWidget*>()) {
        const QString text = widget->property("text").toString();
        if (!widget->isVisible() || text.isEmpty() || widget->inherits("QLineEdit")) continue;
        static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}"));
        INFO(state << ": " << widget->objectName().toStdString() << ": " << text.toStdString());
        CHECK((!word.match(text).hasMatch() || is_korean(text) || is_a_name(text)));
      }
      if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
        hand.window().grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/ko-" + state + ".png");
    };
    hand.act("new");
    check("sketch");
    hand.act("new-perspective");
    check("perspective");
    hand.act("new-surface");
    check("surface");
    hand.open_cage("mug");
    hand.act("show-smooth");
    check("cage");
    open_scan(hand, ball_with_holes(3));
    check("holes");
  }
  app::use_language("en");
  QSettings().remove("language");
}
