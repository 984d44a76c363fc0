// SPDX-License-Identifier: GPL-3.0-or-later
// How commands are found: the menus, the palette, keys and the preferences that change them.
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/hole_scans.h"
#include "app/panels/attribute_panel.h"
#include "app/views/marking_menu.h"
#include "app/window/command_palette.h"
#include "app/window/hotkeys.h"
#include "app/window/preferences.h"
#include "croquis/base/error.h"

using namespace croquis;
using namespace croquis::test;

namespace {

QStringList shown_menus(StudioFixture& hand) {
  QStringList titles;
  for (const QAction* menu : hand.window().menuBar()->actions()) {
    if (menu->isVisible()) titles << app::plain_text(*menu);
  }
  return titles;
}

/// It discards what is drawn without asking.
class Unattended : public StudioFixture {
 public:
  Unattended() { window().set_unattended(); }
};

/// The window with each kind of object active, and with elements picked.
struct State {
  const char* name;
  std::function<void(StudioFixture&)> enter;
};

const std::vector<State>& states() {
  static const std::vector<State> all{{"sketch", [](StudioFixture& hand) { draw_ring(hand); }},
                                      {"perspective", [](StudioFixture& hand) { hand.act("new-perspective"); }},
                                      {"surface", [](StudioFixture& hand) { hand.act("new-surface"); }},
                                      {"objects", [](StudioFixture& hand) { hand.open_cage("mug"); }},
                                      {"edges",
                                       [](StudioFixture& hand) {
                                         hand.open_cage("mug");
                                         hand.act("edge-mode");
                                         hand.act("select-all");
                                       }},
                                      {"holes", [](StudioFixture& hand) {
                                         open_scan(hand, ball_with_holes(3));
                                         hand.act("select-all");
                                       }}};
  return all;
}

void check_underlined_letters(const QMenu& menu) {
  std::map<QString, QString> first;
  for (const QAction* action : menu.actions()) {
    if (action->menu() != nullptr) check_underlined_letters(*action->menu());
    const auto at = action->text().indexOf('&');
    if (at < 0 || !action->isVisible() || action->text().mid(at, 2) == "&&") continue;
    const QString letter = action->text().mid(at + 1, 1).toLower();
    INFO(menu.title().toStdString() << ": " << action->text().toStdString() << ", " << first[letter].toStdString());
    CHECK(first[letter].isEmpty());
    first[letter] = action->text();
  }
}

QDialog* preferences_of(StudioFixture& hand) {
  hand.act("preferences");
  auto* dialog = hand.window().findChild<QDialog*>("preferences");
  REQUIRE(dialog != nullptr);
  return dialog;
}

void select_row(QTreeWidget& list, const QString& text) {
  const auto found = list.findItems(text, Qt::MatchExactly, 0);
  REQUIRE(!found.isEmpty());
  list.setCurrentItem(found.front());
}

}  // namespace

TEST_CASE("menus are those that people know; those of one kind of object are shown with it", "[commands]") {
  Unattended hand;
  hand.act("new");
  const QStringList known{"File", "Edit", "Create", "Select", "Modify", "Mesh", "Sketch", "View", "Window", "Help"};
  CHECK(shown_menus(hand) == known);
  const std::map<std::string, QString> own{{"perspective", "Perspective"}, {"surface", "Surface"}, {"holes", "Holes"}};
  for (const State& state : states()) {
    INFO(state.name);
    state.enter(hand);
    hand.settle();
    QStringList shown = shown_menus(hand);
    const auto menu = own.find(state.name);
    if (menu != own.end()) CHECK(shown.removeAll(menu->second) == 1);
    CHECK(shown == known);
  }
}

TEST_CASE("each command stands in a menu, and no two in one menu have the same letter", "[commands]") {
  Unattended hand;
  hand.open_cage("mug");
  for (const QAction* action : hand.window().actions()) {
    INFO(action->objectName().toStdString());
    if (!app::plain_text(*action).isEmpty()) CHECK(!app::menu_place(*action).isEmpty());
  }
  std::set<QString> letters;
  for (const QAction* menu : hand.window().menuBar()->actions()) {
    const auto at = menu->text().indexOf('&');
    CHECK(letters.insert(menu->text().mid(at + 1, 1).toLower()).second);
    emit menu->menu()->aboutToShow();
    check_underlined_letters(*menu->menu());
  }
}

TEST_CASE("files that were opened lately are in the menu File", "[commands]") {
  Unattended hand;
  hand.act("new");
  draw_ring(hand);
  const QString path = hand.folder() + "/Fish & chips.croq";
  hand.window().files().save(path);
  hand.act("new");
  auto* recent = hand.window().findChild<QMenu*>("recent");
  REQUIRE(recent != nullptr);
  emit recent->aboutToShow();
  REQUIRE(!recent->actions().isEmpty());
  CHECK(recent->actions().front()->text() == "Fish && chips.croq");
  hand.window().set_unattended();
  recent->actions().front()->trigger();
  CHECK(hand.wait_for([&] { return hand.window().files().path() == path; }));
}

TEST_CASE("the palette finds every command by its name, and by parts of it", "[commands]") {
  Unattended hand;
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  const std::vector<app::Command> commands = app::all_commands(hand.window());
  std::set<QString> texts;
  for (const app::Command& command : commands) texts.insert(command.text);
  for (const QAction* action : hand.window().actions())
    CHECK((action->text().isEmpty() || texts.contains(app::plain_text(*action))));
  for (const char* wanted : {"Smoothing", "Linked rings", "Drawings in perspective"}) {
    INFO(wanted);
    CHECK(std::ranges::any_of(texts, [&](const QString& text) { return text.startsWith(wanted); }));
  }
  for (const app::Command& command : commands) {
    INFO(command.text.toStdString());
    const auto found = app::found_commands(commands, command.text);
    const auto end = found.begin() + std::min<std::ptrdiff_t>(3, std::ssize(found));
    CHECK(std::any_of(found.begin(), end, [&](std::size_t i) { return commands[i].text == command.text; }));
  }
  CHECK(app::match_of("loop cut", "Link pieces by a construction line") == 0);
  const auto first = [&](const QString& typed) {
    const auto found = app::found_commands(commands, typed);
    return found.empty() ? QString() : commands[found.front()].text;
  };
  CHECK(first("exfa") == "Extrude faces");
  CHECK(first("loop cut") == "Loop cut");
  CHECK(first("edge ring") == "Edge ring");
  CHECK(first("zzzq").isEmpty());
}

TEST_CASE("F3, a few letters and Enter do a command", "[commands]") {
  Unattended hand;
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  QApplication::setActiveWindow(&hand.window());
  QTest::keyClick(&hand.viewport(), Qt::Key_F3);
  auto* palette = hand.window().findChild<QDialog*>("palette");
  REQUIRE(palette != nullptr);
  auto* field = palette->findChild<QLineEdit*>();
  QTest::keyClicks(field, "four v");
  if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
    palette->grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/palette.png");
  QTest::keyClick(field, Qt::Key_Return);
  CHECK(hand.wait_for([&] { return hand.viewport().pane(app::TopView).visible(); }));
  // A parameter gets the keyboard, also one for experts.
  hand.act("palette");
  palette = hand.window().findChild<QDialog*>("palette");
  REQUIRE(palette != nullptr);
  field = palette->findChild<QLineEdit*>();
  QTest::keyClicks(field, "ends of sharp");
  QTest::keyClick(field, Qt::Key_Return);
  const auto* panel = hand.window().findChild<app::AttributePanel*>();
  CHECK(hand.wait_for([&] {
    const QWidget* focus = hand.window().focusWidget();
    return focus != nullptr && panel->isAncestorOf(focus);
  }));
  CHECK(panel->field("chain-ends")->isVisible());
  // What can't be done now is listed and stays without effect.
  hand.act("deselect");
  hand.act("palette");
  palette = hand.window().findChild<QDialog*>("palette");
  field = palette->findChild<QLineEdit*>();
  QTest::keyClicks(field, "bridge selected rims");
  const int steps = static_cast<int>(hand.studio().session().undo_labels().size());
  QTest::keyClick(field, Qt::Key_Return);
  CHECK(palette->isVisible());
  QTest::keyClick(field, Qt::Key_Escape);
  CHECK(static_cast<int>(hand.studio().session().undo_labels().size()) == steps);
}

TEST_CASE("no key does two things at once, with any preset and whatever is active", "[keys]") {
  Unattended hand;
  for (const State& state : states()) {
    state.enter(hand);
    hand.settle();
    for (const auto& [preset, title] : app::key_presets()) {
      app::apply_keys({preset, {}}, hand.window().actions());
      std::map<QKeySequence, QString> owners;
      for (const QAction* action : hand.window().actions()) {
        if (!action->isEnabled() || !action->isVisible()) continue;
        for (const QKeySequence& key : action->shortcuts()) {
          INFO(preset.toStdString() << ", " << state.name << ", " << key.toString().toStdString() << ": "
                                    << owners[key].toStdString() << ", " << action->objectName().toStdString());
          CHECK(owners[key].isEmpty());
          owners[key] = action->objectName();
        }
      }
    }
  }
}

TEST_CASE("presets name commands that exist", "[keys]") {
  Unattended hand;
  for (const QString& file : QDir(":/keys").entryList()) {
    QFile preset(":/keys/" + file);
    REQUIRE(preset.open(QIODevice::ReadOnly));
    const app::KeyMap map = app::key_map_of("{\"preset\": \"maya\", \"keys\": " + preset.readAll() + "}", file);
    CHECK(map.own.size() > 8);
    for (auto each = map.own.begin(); each != map.own.end(); ++each) {
      INFO(file.toStdString() << ": " << each.key().toStdString());
      CHECK(hand.window().action(each.key()) != nullptr);
    }
  }
}

TEST_CASE("keys are changed in the preferences, work at once, and are kept", "[keys]") {
  Unattended hand;
  hand.open_cage("mug");
  QDialog* dialog = preferences_of(hand);
  auto* list = dialog->findChild<QTreeWidget*>("keys");
  dialog->findChild<QLineEdit*>("search")->setText("loop cut");
  int shown = 0;
  for (int i = 0; i < list->topLevelItemCount(); ++i) shown += list->topLevelItem(i)->isHidden() ? 0 : 1;
  CHECK(shown >= 1);
  CHECK(shown < 5);
  select_row(*list, "Loop cut");
  auto* field = dialog->findChild<QKeySequenceEdit*>("key");
  field->setKeySequence(QKeySequence("W"));
  CHECK(dialog->findChild<QLabel*>("clash")->text().contains("Move (Modify)"));
  field->setKeySequence(QKeySequence("Ctrl+Alt+L"));
  CHECK(dialog->findChild<QLabel*>("clash")->text().isEmpty());
  if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
    dialog->grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/preferences.png");
  QTest::mouseClick(dialog->findChild<QPushButton*>("set-key"), Qt::LeftButton);
  CHECK(hand.window().action("loop-cut")->shortcut() == QKeySequence("Ctrl+Alt+L"));
  // An empty field takes the key away.
  select_row(*list, "Edge ring");
  field->clear();
  QTest::mouseClick(dialog->findChild<QPushButton*>("set-key"), Qt::LeftButton);
  CHECK(hand.window().action("select-ring")->shortcuts().isEmpty());
  QTest::mouseClick(dialog->findChild<QPushButton*>("reset-key"), Qt::LeftButton);
  CHECK(hand.window().action("select-ring")->shortcut() == QKeySequence("Shift+R"));
  auto* preset = dialog->findChild<QComboBox*>("key-preset");
  preset->setCurrentIndex(preset->findData("blender"));
  CHECK(hand.window().action("move")->shortcut() == QKeySequence("G"));
  CHECK(hand.window().action("loop-cut")->shortcut() == QKeySequence("Ctrl+Alt+L"));
  dialog->close();
  hand.crash_and_restart();
  CHECK(hand.window().action("move")->shortcut() == QKeySequence("G"));
  CHECK(hand.window().action("loop-cut")->shortcut() == QKeySequence("Ctrl+Alt+L"));
  dialog = preferences_of(hand);
  select_row(*dialog->findChild<QTreeWidget*>("keys"), "Loop cut");
  QTest::mouseClick(dialog->findChild<QPushButton*>("reset-key"), Qt::LeftButton);
  CHECK(hand.window().action("loop-cut")->shortcut() == QKeySequence("Ctrl+R"));
  preset = dialog->findChild<QComboBox*>("key-preset");
  preset->setCurrentIndex(preset->findData("maya"));
  CHECK(hand.window().action("loop-cut")->shortcut() == QKeySequence("K"));
  CHECK(hand.window().action("move")->shortcut() == QKeySequence("W"));
}

TEST_CASE("lists of keys are files; one that is none says what is wrong with it", "[keys]") {
  const app::KeyMap map{"cad", {{"move", {QKeySequence("Ctrl+M"), QKeySequence("F7")}}, {"erase", {}}}};
  CHECK(app::key_map_of(app::json_of(map), "keys.json") == map);
  const std::vector<std::pair<QByteArray, const char*>> wrong{
      {"{", "keys.json"},
      {"{\"preset\": \"vi\"}", "\"vi\""},
      {"{\"preset\": \"maya\", \"keys\": {\"move\": \"W\"}}", "\"move\""},
      {"{\"preset\": \"maya\", \"keys\": {\"move\": [\"Hyper+Foo\"]}}", "\"Hyper+Foo\""}};
  for (const auto& [json, part] : wrong) {
    INFO(json.toStdString());
    try {
      app::key_map_of(json, "keys.json");
      FAIL("it was read");
    } catch (const Error& error) {
      CHECK(error.findings().front().code == "E_SYNTAX");
      CHECK(error.findings().front().message.find(part) != std::string::npos);
    }
  }
}

TEST_CASE("the middle button rotates the view as people know it from Blender, once they say so", "[keys]") {
  Unattended hand;
  hand.open_cage("mug");
  hand.act("perspective-alone");
  const auto turned_by_middle = [&] {
    const auto before = hand.viewport().pane(app::PerspectiveView).camera.eye;
    const QPointF middle = hand.viewport().rect().center();
    hand.drag_pixels(middle, middle + QPointF(80, 30), Qt::MiddleButton, Qt::NoModifier);
    return hand.viewport().pane(app::PerspectiveView).camera.eye != before;
  };
  CHECK(!turned_by_middle());
  QDialog* dialog = preferences_of(hand);
  auto* navigation = dialog->findChild<QComboBox*>("navigation");
  navigation->setCurrentIndex(navigation->findData("blender"));
  dialog->close();
  CHECK(turned_by_middle());
  hand.crash_and_restart();
  hand.open_cage("mug");
  hand.act("perspective-alone");
  CHECK(turned_by_middle());
  QSettings().remove("navigation");
}
