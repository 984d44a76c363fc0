// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of what it does, and that it does what it says.
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QScreen>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QToolButton>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "app/hole_scans.h"
#include "app/panels/attribute_panel.h"
#include "app/panels/lists.h"
#include "app/panels/number_box.h"
#include "app/replay/replay_player.h"
#include "app/tools/holes/hole_table.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "app/window/help_pages.h"
#include "app/window/language.h"
#include "app/window/panel_docks.h"
#include "support/sketches/sketch_gallery.h"

namespace croquis::test {
namespace {

QString label_text(StudioFixture& hand, const char* name) { return hand.window().findChild<QLabel*>(name)->text(); }

/// Three strokes of the tool that close a triangle on the ground.
void draw_triangle(StudioFixture& hand) {
  hand.act("new-surface");
  hand.settle();
  app::DrawnNetwork& network = hand.window().tool<app::SurfaceDrawingTool>().network();
  const std::array<Vec3, 3> corners{Vec3(-100, -60, 0), Vec3(100, -60, 0), Vec3(0, 80, 0)};
  for (std::size_t k = 0; k < 3; ++k) {
    recorded::SurfaceStroke stroke;
    const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
    for (int i = 0; i <= 20; ++i) stroke.points.push_back(from + (to - from) * i / 20.0);
    stroke.unit = 1;
    const AttributeNetwork& now = network.network();
    if (k > 0) stroke.start.node = now.nodes[k].id;
    if (k == 2) stroke.end.node = now.nodes[0].id;
    network.act(stroke);
    hand.settle();
  }
}

}  // namespace

TEST_CASE("numbers have the digits that they need and no more", "[words]") {
  using app::number_words;
  CHECK(number_words(0.0005) == "0.0005");
  CHECK(number_words(1e-6) == "0.000001");
  CHECK(number_words(164.587) == "164.6");
  CHECK(number_words(15) == "15");
  CHECK(number_words(-0.25) == "-0.25");
  CHECK(number_words(0) == "0");
  CHECK(number_words(1234567) == "1234567");
  CHECK(number_words(1350.4, 3) == "1350");
  CHECK(number_words(3e-12) == "3e-12");
  const std::unique_ptr<QDoubleSpinBox> box(app::make_number_box(nullptr, "box", {0, 1e9, 3}));
  for (const double value : {0.0005, 1e-6, 0.1, 15.0, 123456.789}) {
    box->setValue(value);
    CHECK(box->value() == value);
    CHECK(box->text().toDouble() == value);
  }
  box->setValue(0.00012345678);
  box->selectAll();
  QTest::keyClick(box.get(), Qt::Key_Return);  // what is shown is rounded, what is kept isn't
  CHECK(box->value() == 0.00012345678);
  box->selectAll();
  QTest::keyClicks(box.get(), "2e-7");
  QTest::keyClick(box.get(), Qt::Key_Return);
  CHECK(box->value() == 2e-7);
}

TEST_CASE("ids that nobody typed are shown as numbers, names and files stay", "[words]") {
  CHECK(app::localized("Draw stroke s10") == "Draw stroke 10");
  CHECK(app::localized("Strokes s3, s5 and s12.") == "Strokes 3, 5 and 12.");
  CHECK(app::localized("Stroke c7 and stroke e33") == "Stroke c7 and stroke e33");  // of a file
  CHECK(app::localized("Patch f1: curve c4, point p2, node n7") == "Patch 1: curve 4, point 2, node 7");
  for (const char* same :
       {"Saved f3.obj", "The group \"c3\" is empty", "/tmp/f1/c2.png", "c3_left", "scarf12", "G1, C2"})
    CHECK(app::localized(same) == same);
}

TEST_CASE("the perspective panel and the history name drawn strokes by numbers alone", "[words]") {
  StudioFixture hand;
  hand.window().set_unattended();
  hand.act("new-perspective");
  auto& sheet = hand.window().tool<app::PerspectiveDrawingTool>().sheet();
  for (const auto& [from, to] : std::array<std::pair<Vec2, Vec2>, 7>{{{{416, 627}, {407, 384}},
                                                                      {{407, 384}, {792, 247}},
                                                                      {{407, 384}, {234, 240}},
                                                                      {{416, 627}, {765, 468}},
                                                                      {{416, 627}, {257, 460}},
                                                                      {{765, 468}, {792, 247}},
                                                                      {{257, 460}, {234, 240}}}}) {
    recorded::SheetStroke stroke;
    for (int i = 0; i <= 8; ++i) stroke.points.push_back(from + (to - from) * i / 8.0);
    sheet.take(stroke);
    hand.settle();
  }
  const auto* lines = hand.window().findChild<QTreeWidget*>("perspective-lines");
  REQUIRE(lines->topLevelItemCount() > 3);
  for (int row = 0; row < lines->topLevelItemCount(); ++row) CHECK(lines->topLevelItem(row)->text(0).toInt() > 0);
  CHECK(hand.window().findChild<app::HistoryList*>("history")->item(7)->text() == "Draw stroke 7");
}

TEST_CASE("empty panels say what belongs there", "[words]") {
  StudioFixture hand;
  hand.act("new");
  hand.settle();
  const auto* objects = hand.window().findChild<QTreeWidget*>("objects");
  REQUIRE(objects->topLevelItemCount() == 0);
  const auto ink = [&] {
    const QImage picture = objects->viewport()->grab().toImage();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) != picture.pixel(0, 0) ? 1 : 0;
    }
    return count;
  };
  CHECK(ink() > 100);
  const auto* hint = hand.window().findChild<QLabel*>("attributes-hint");
  CHECK(hint->isVisibleTo(&hand.window()));
  draw_triangle(hand);
  CHECK_FALSE(hint->isVisibleTo(&hand.window()));
}

TEST_CASE("edits are listed in words, and nothing else of them is shown", "[words]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  hand.act("face-mode");
  hand.mesh().act([](MeshTool& tool) { return tool.selection().pick(ComponentKind::Face, {10, 11}); });
  hand.mesh().act([](MeshTool& tool) { return tool.take(recorded::Move{.by = {0, 0, 5}}); });
  hand.settle();
  const auto* lines = hand.window().findChild<QListWidget*>("edit-lines");
  REQUIRE(lines != nullptr);
  REQUIRE(lines->count() == 1);
  CHECK(lines->item(0)->text() == "Move 2 faces");
  CHECK(hand.window().findChild<app::ParameterField*>("do") == nullptr);
  CHECK(hand.window().findChild<app::ParameterField*>("connectivity") == nullptr);
}

TEST_CASE("the history names parameters by their titles and values", "[words]") {
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  hand.act("finer");
  CHECK(hand.studio().session().undo_labels().back() == "Level 3");
  auto* scheme = hand.window().findChild<app::ParameterField*>("scheme")->findChild<QComboBox*>();
  CHECK(scheme->itemText(1) == "Standard (Catmull-Clark)");
  scheme->setCurrentIndex(1);
  CHECK(hand.studio().session().undo_labels().back() == "Smoothing Standard (Catmull-Clark)");
}

TEST_CASE("key 3 shows the smooth surface alone, also while edges are picked", "[words]") {
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("show-both");
  hand.settle();
  const auto drawn = [&] {
    app::ObjectScenes::Wanted wanted;
    for (const auto& tool : hand.window().tools()) tool->adjust(wanted, app::PerspectiveView);
    return hand.viewport().objects().scene(wanted).meshes.size();
  };
  hand.act("edge-mode");
  hand.settle();
  CHECK(drawn() == 2);
  hand.act("show-smooth");
  hand.settle();
  CHECK(drawn() == 1);
  hand.act("edge-mode");
  hand.settle();
  CHECK(drawn() == 2);
}

TEST_CASE("what a drag of a handle has done stands at the pointer", "[words]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "box");
  hand.act("perspective-alone");
  hand.act("face-mode");
  hand.mesh().act([](MeshTool& tool) { return tool.selection().pick(ComponentKind::Face, {0}); });
  hand.act("move");
  hand.settle();
  REQUIRE(hand.mesh().tool().manipulator());
  const Vec3 pivot = hand.mesh().tool().manipulator()->pivot;
  const QPointF from = app::model_to_widget(hand.viewport().views(), pivot, app::PerspectiveView);
  hand.send_mouse(QEvent::MouseMove, from, Qt::NoButton, {});
  hand.send_mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, {});
  hand.send_mouse(QEvent::MouseMove, from + QPointF(30, 0), Qt::LeftButton, {});
  hand.send_mouse(QEvent::MouseMove, from + QPointF(60, 0), Qt::LeftButton, {});
  hand.picture();
  const auto& motion = hand.mesh().tool().preview().motion;
  REQUIRE(motion);
  const auto* value = hand.viewport().findChild<QLabel*>("pointer-value");
  CHECK(value->isVisible());
  CHECK(value->text().startsWith(app::number_words(motion->by.norm())));
  CHECK(app::help_of(hand.viewport().views()).startsWith(value->text()));
  hand.send_mouse(QEvent::MouseButtonRelease, from + QPointF(60, 0), Qt::LeftButton, {});
  hand.picture();
  CHECK_FALSE(value->isVisible());
}

TEST_CASE("a drag of strokes, curves and lines in perspective says how far it has come", "[words]") {
  for (const char* kind : {"sketch", "new-perspective", "new-surface"}) {
    INFO(kind);
    StudioFixture hand;
    hand.window().set_unattended();
    const bool is_surface = kind == std::string("new-surface");
    if (kind != std::string("sketch")) hand.act(kind);
    app::show_views(hand.window());
    hand.settle();
    const int view = is_surface ? app::PerspectiveView : app::SketchView;
    const QPointF middle = hand.viewport().pane(view).rect.center();
    hand.drag_pixels(middle - QPointF(80, 0), middle + QPointF(80, 0), Qt::LeftButton, {});
    hand.settle();
    hand.act("select");
    hand.send_mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, {});
    for (const int by : {10, 20, 40}) hand.send_mouse(QEvent::MouseMove, middle + QPointF(by, by), Qt::LeftButton, {});
    hand.picture();
    const auto* value = hand.viewport().findChild<QLabel*>("pointer-value");
    REQUIRE(value != nullptr);
    CHECK(value->isVisible());
    CHECK(value->text().contains(QRegularExpression("x -?[0-9.]+  y -?[0-9.]+")));
    CHECK(value->text().contains("  z ") == is_surface);
    hand.send_mouse(QEvent::MouseButtonRelease, middle + QPointF(40, 40), Qt::LeftButton, {});
    hand.picture();
    CHECK_FALSE(value->isVisible());
  }
}

TEST_CASE("points and inner curves say what they lack before there is a patch", "[words]") {
  StudioFixture hand;
  hand.act("new-surface");
  hand.settle();
  for (const char* mode : {"surface-point", "inner-curve"}) {
    hand.act(mode);
    CHECK(app::help_of(hand.viewport().views()).contains("no patch yet"));
    const QPointF middle = hand.viewport().pane(app::PerspectiveView).rect.center();
    hand.send_mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, {});
    hand.send_mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton, {});
    CHECK(label_text(hand, "message").contains("no patch yet"));
  }
}

TEST_CASE("a closed loop of curves offers its patch by itself", "[words]") {
  StudioFixture hand;
  draw_triangle(hand);
  const AttributeNetwork& network = hand.window().tool<app::SurfaceDrawingTool>().network().network();
  REQUIRE(network.curves.size() == 3);
  REQUIRE(network.nodes.size() == 3);
  hand.picture();
  const auto* chip = hand.viewport().findChild<QToolButton*>("patch-chip");
  CHECK(chip->isVisible());
  QTest::keyClick(&hand.viewport(), Qt::Key_Return);
  hand.settle();
  CHECK(hand.window().tool<app::SurfaceDrawingTool>().network().network().faces.size() == 1);
  hand.picture();
  CHECK_FALSE(chip->isVisible());
}

TEST_CASE("looking for holes where there are none says so and adds no step", "[words]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "box");
  const auto steps = hand.studio().session().undo_labels();
  const std::size_t nodes = hand.studio().session().document().nodes().size();
  hand.act("holes");
  hand.settle();
  CHECK(hand.studio().session().undo_labels() == steps);
  CHECK(hand.studio().session().document().nodes().size() == nodes);
  CHECK(label_text(hand, "message").contains("has no holes"));
  CHECK(hand.viewport().views().mode != "holes");
}

TEST_CASE("the sheet of a new drawing in perspective has half of the views' width at least", "[words]") {
  StudioFixture hand;
  for (const QSize size : {QSize(1600, 960), QSize(1280, 680)}) {
    hand.window().resize(size);
    hand.act("new-perspective");
    app::show_views(hand.window());
    hand.settle();
    const Vec2 sheet = hand.window().tool<app::PerspectiveDrawingTool>().sheet().drawing().image_size;
    const double width = app::sketch_to_widget(hand.viewport().views(), {sheet.x(), 0}).x() -
                         app::sketch_to_widget(hand.viewport().views(), {0, 0}).x();
    CHECK(width >= 0.5 * hand.viewport().width());
    CHECK(hand.viewport().views().layout.shares().x() == 0.5);  // nobody has moved the border
  }
  hand.act("new");
  hand.settle();
  CHECK(hand.viewport().pane(app::SketchView).rect.width() < 0.51 * hand.viewport().width());
}

TEST_CASE("while one draws in perspective, keys of groups mean the same wherever the pointer is", "[words]") {
  StudioFixture hand;
  hand.act("new-perspective");
  app::show_views(hand.window());
  hand.settle();
  const QPointF solid = hand.viewport().pane(app::PerspectiveView).rect.center();
  hand.send_mouse(QEvent::MouseMove, solid, Qt::NoButton, {});
  hand.viewport().setFocus();
  QTest::keyClick(&hand.viewport(), Qt::Key_2);
  const auto& group = hand.window().tool<app::PerspectiveDrawingTool>().sheet().tool.group();
  REQUIRE(group);
  CHECK(*group == StrokeGroup::ParallelY);
}

TEST_CASE("the window leaves room for a title bar on a small screen", "[words]") {
  QWidget window;
  const QRect free = window.screen()->availableGeometry();
  window.resize(free.size());
  app::fit_to_screen(window);
  CHECK(window.height() <= free.height() - 30);
  StudioFixture hand;
  CHECK(hand.window().minimumSizeHint().height() <= 640);
}

TEST_CASE("words of panels aren't clipped in a small window", "[words]") {
  StudioFixture hand;
  hand.window().resize(1280, 680);
  hand.act("new-perspective");
  app::show_views(hand.window());
  hand.settle();
  for (const QLabel* label : hand.window().findChildren<QLabel*>()) {
    if (label->text() != "Unit of lengths") continue;
    CHECK(label->width() >= label->sizeHint().width());
  }
  open_scan(hand, ball_with_holes(6));
  const auto* table = hand.window().findChild<app::HoleTable*>("holes");
  REQUIRE(table != nullptr);
  CHECK(table->viewport()->height() >= 4 * table->rowHeight(0));
  CHECK(table->horizontalHeaderItem(3)->text() == "Diameter (units)");
}

TEST_CASE("diameters of holes have the document's unit", "[words]") {
  StudioFixture hand;
  hand.act("new-perspective");
  auto& tool = hand.window().tool<app::PerspectiveDrawingTool>().sheet().tool;
  tool.take(recorded::SheetStroke{{{300, 300}, {350, 320}, {420, 350}}, {}, StrokeRole::Edge, false, 1, {}});
  tool.take(recorded::SheetUnit{"cm"});
  open_scan(hand, ball_with_holes(2));
  const auto* table = hand.window().findChild<app::HoleTable*>("holes");
  REQUIRE(table != nullptr);
  CHECK(table->horizontalHeaderItem(3)->text() == "Diameter (cm)");
}

TEST_CASE("the menu Help has the manual, the keys, the examples, and what to copy for helpers", "[words]") {
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("edge-mode");
  hand.act("help");
  const auto* manual = hand.window().findChild<QDialog*>("manual");
  REQUIRE(manual != nullptr);
  const auto* page = manual->findChild<QTextBrowser*>();
  CHECK(page->textCursor().block().text() == "Meshes");
  CHECK(page->toPlainText().contains("Undo and kept results"));
  hand.act("help-keys");
  const QString keys = hand.window().findChild<QDialog*>("keys")->findChild<QTextBrowser*>()->toPlainText();
  int listed = 0;
  for (const QAction* action : hand.window().actions()) {
    const QString key = app::keys_of(*action);
    const QString what = action->text().section('\t', 0, 0).remove('&').remove("…");
    if (key.isEmpty() || !action->isEnabled() || !action->isVisible()) continue;
    INFO(what.toStdString());
    CHECK(keys.contains(what));
    CHECK(keys.contains(key));
    ++listed;
  }
  CHECK(listed > 40);
  hand.act("help-about");
  CHECK(hand.window().findChild<QDialog*>("about")->isVisible());
  hand.act("help-examples");
  CHECK(!hand.window().shows_views());
  CHECK(hand.window().action("help")->isEnabled());
}

}  // namespace croquis::test
