// SPDX-License-Identifier: GPL-3.0-or-later
// What people do on a perspective drawing with the pen or the mouse beside drawing strokes.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <functional>
#include <set>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/tools/perspective/sheet_scene.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::test {
namespace {

app::Sheet& open_sheet(StudioFixture& hand, const PerspectiveDrawing& drawing) {
  app::start_with(hand.studio(), drawing);
  app::show_views(hand.window());
  hand.settle();
  hand.picture();
  return hand.window().tool<app::PerspectiveDrawingTool>().sheet();
}

PerspectiveDrawing plain(const PerspectiveSolid& solid) {
  SolidDrawingOptions options;
  options.vertex_ids = false;
  options.known = false;
  return drawn(solid, three_point_views()[1], options).drawing;
}

QString chip_text(StudioFixture& hand) {
  hand.picture();
  const auto* chip = hand.viewport().findChild<QToolButton*>("perspective-faces");
  return chip->isVisible() ? chip->text().replace('\n', ' ') : QString();
}

QPointF on_screen(StudioFixture& hand, const Vec2& sheet) {
  return app::sketch_to_widget(hand.viewport().views(), {sheet.x(), -sheet.y()});
}

/// A place of the sheet view where nothing is drawn.
QPointF empty_place(StudioFixture& hand) {
  return hand.viewport().pane(app::SketchView).rect.bottomLeft() + QPointF(120, -120);
}

TEST_CASE("an empty sheet says what to draw, in full, and computes nothing", "[perspective-pen]") {
  StudioFixture hand;
  hand.act("new-perspective");
  app::show_views(hand.window());
  for (const QSize size : {QSize(1440, 900), QSize(1024, 640)}) {
    hand.window().resize(size);
    hand.settle();
    hand.picture();
    const auto* hint = hand.window().findChild<QLabel*>("perspective-hint");
    REQUIRE(hint != nullptr);
    CHECK(hint->isVisible());
    CHECK(hint->height() >= hint->heightForWidth(hint->width()));
  }
  REQUIRE(hand.studio().active() != nullptr);
  for (const ChainStep& step : steps_of(hand.studio(), *hand.studio().active())) {
    CHECK(step.state == (step.title.empty() ? StepState::Source : StepState::Waiting));
  }
}

TEST_CASE("a flick with the right button, or with G held, chooses a group without reading the ring",
          "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, plain(box()));
  hand.viewport().setFocus();
  const QPointF at = empty_place(hand);
  const auto flick = [&](const QPointF& way) { hand.drag_pixels(at, at + way, Qt::RightButton, Qt::NoModifier); };
  flick({60, 0});
  CHECK(sheet.tool.group() == StrokeGroup::ParallelX);
  flick({0, -60});
  CHECK(sheet.tool.group() == StrokeGroup::ParallelZ);
  flick({45, -45});
  CHECK(sheet.tool.group() == StrokeGroup::NormalX);
  flick({-45, -45});
  CHECK_FALSE(sheet.tool.group());
  flick({0, 60});
  CHECK(sheet.tool.role() == StrokeRole::Construction);
  flick({0, 60});
  CHECK(sheet.tool.role() == StrokeRole::Edge);
  flick({3, 2});
  CHECK_FALSE(sheet.tool.group());

  hand.send_mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoModifier);
  QTest::keyPress(&hand.viewport(), Qt::Key_G);
  REQUIRE(hand.viewport().marking_menu().is_open());
  hand.send_mouse(QEvent::MouseMove, at + QPointF(-50, 2), Qt::NoButton, Qt::NoModifier);
  CHECK(hand.viewport().marking_menu().is_open());
  QTest::keyRelease(&hand.viewport(), Qt::Key_G);
  CHECK_FALSE(hand.viewport().marking_menu().is_open());
  CHECK(sheet.tool.group() == StrokeGroup::ParallelY);
}

TEST_CASE("the chip says what a closed solid lacks, and a click shows the strokes", "[perspective-pen]") {
  StudioFixture hand;
  PerspectiveDrawing whole = plain(box());
  app::Sheet& sheet = open_sheet(hand, whole);
  CHECK(chip_text(hand) == "Solid closed");

  // Without one edge two flat faces become a bent one, and that closes.
  PerspectiveDrawing lacking = whole;
  const auto edge = std::ranges::find(lacking.strokes, StrokeRole::Edge, &PerspectiveStroke::role);
  remove_strokes(lacking, {edge->id});
  open_sheet(hand, lacking);
  CHECK(chip_text(hand) == "Closed, but one face is bent: a stroke is probably missing");
  hand.viewport().findChild<QToolButton*>("perspective-faces")->click();
  CHECK(sheet.tool.selected().size() == 6);

  // A stroke that nothing joins is left out of the solid.
  PerspectiveDrawing more = whole;
  add_stroke(more, {{line_piece({50, 50}, {120, 90})}, true}, StrokeGroup::Unknown, StrokeRole::Edge);
  open_sheet(hand, more);
  CHECK(chip_text(hand) == "Closed, but one edge is left out");

  PerspectiveDrawing few = whole;
  std::vector<std::string> all;
  for (const PerspectiveStroke& stroke : few.strokes) {
    if (stroke.role == StrokeRole::Edge) all.push_back(stroke.id);
  }
  remove_strokes(few, {all.begin() + 2, all.end()});
  open_sheet(hand, few);
  CHECK(chip_text(hand) == "2 edges, no face yet");
}

TEST_CASE("coordinates and lengths are typed at the pen, with units", "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, plain(box()));
  hand.viewport().setFocus();
  auto* entry = hand.viewport().findChild<QLineEdit*>("perspective-entry");
  REQUIRE(entry != nullptr);
  sheet.tool.take(recorded::SheetUnit{"mm"});
  const std::string edge = std::ranges::find(sheet.drawing().strokes, StrokeRole::Edge, &PerspectiveStroke::role)->id;
  const PerspectiveStroke stroke = *find_stroke(sheet.drawing(), edge);

  hand.send_mouse(QEvent::MouseMove, on_screen(hand, stroke.start()), Qt::NoButton, Qt::NoModifier);
  QTest::keyClick(&hand.viewport(), Qt::Key_K);
  CHECK(sheet.picks == app::SheetPick::Point);
  hand.drag_pixels(on_screen(hand, stroke.start()), on_screen(hand, stroke.start()), Qt::LeftButton, Qt::NoModifier);
  REQUIRE(entry->isVisible());
  QTest::keyClicks(entry, "what");
  QTest::keyClick(entry, Qt::Key_Return);
  CHECK(entry->isVisible());  // can't be read: it stays
  CHECK_FALSE(sheet.drawing().known_point);
  entry->selectAll();
  QTest::keyClicks(entry, "1 2 3 cm");
  QTest::keyClick(entry, Qt::Key_Return);
  CHECK_FALSE(entry->isVisible());
  REQUIRE(sheet.drawing().known_point);
  CHECK((sheet.drawing().known_point->point - Vec3(10, 20, 30)).norm() < 1e-9);
  CHECK(sheet.drawing().known_point->at == stroke.start());
  hand.act("undo");
  CHECK_FALSE(sheet.drawing().known_point);
  hand.act("redo");

  sheet.tool.select({edge});
  hand.act("known-length");
  REQUIRE(entry->isVisible());
  QTest::keyClicks(entry, "12 cm");
  QTest::keyClick(entry, Qt::Key_Return);
  REQUIRE(sheet.drawing().known_lengths.size() == 1);
  CHECK(sheet.drawing().known_lengths[0].length == Approx(120));
  hand.settle();
  const auto* size = hand.window().findChild<QLabel*>("perspective-size");
  REQUIRE(size != nullptr);
  CHECK(size->text().contains("120"));
  CHECK(size->text().endsWith("mm"));

  hand.act("known-length");
  QTest::keyClick(entry, Qt::Key_Escape);
  CHECK(sheet.drawing().known_lengths.size() == 1);
}

TEST_CASE("mode, flip and unit are set in the tool's panel, each an undo step", "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, plain(box()));
  const Vec3 x_before = sheet.result()->camera.rotation.col(0);
  auto* flip = hand.window().findChild<QCheckBox*>("perspective-flip");
  REQUIRE(flip != nullptr);
  flip->click();
  hand.settle();
  CHECK((sheet.result()->camera.rotation.col(0) + x_before).norm() < 1e-9);
  CHECK(sheet.result()->closed);
  hand.act("undo");
  hand.settle();
  CHECK((sheet.result()->camera.rotation.col(0) - x_before).norm() < 1e-9);
  CHECK_FALSE(flip->isChecked());
  auto* mode = hand.window().findChild<QComboBox*>("perspective-mode");
  mode->setCurrentIndex(mode->findData("2"));
  emit mode->activated(mode->currentIndex());
  hand.settle();
  REQUIRE(sheet.result() != nullptr);
  CHECK(sheet.result()->mode == 2);
  hand.act("undo");
  hand.settle();
  CHECK(sheet.result()->mode == 3);
  CHECK(mode->currentData() == "auto");
}

/// Two boxes of one size beside each other, every corner joined to its own: several sets of faces fit as well.
PerspectiveDrawing joined_boxes() {
  PerspectiveSolid solid;
  solid.name = "joined boxes";
  CurveNetwork& network = solid.network;
  for (Index i = 0; i < 16; ++i) {
    const Vec3 corner(i & 1 ? 2 : -2, i & 2 ? 1.5 : -1.5, i & 4 ? 1 : -1);
    network.vertices.push_back(i < 8 ? corner : Vec3(corner + Vec3(1.3, 0, 0.9)));
  }
  for (Index i = 0; i < 16; ++i) {
    for (Index bit = 1, axis = 0; bit < 16; bit *= 2, ++axis) {
      if ((i & bit) != 0) continue;
      NetworkCurve curve;
      curve.id = "e" + std::to_string(network.curves.size());
      curve.start = i;
      curve.end = i | bit;
      curve.pieces = {straight_cubic(network.vertices[i], network.vertices[i | bit])};
      curve.straight = true;
      network.curves.push_back(std::move(curve));
      solid.groups.push_back(axis < 3 ? static_cast<StrokeGroup>(axis) : StrokeGroup::NormalY);
    }
  }
  return plain(solid);
}

TEST_CASE("other sets of faces are seen under the pointer and taken by a click, which is one step back",
          "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, joined_boxes());
  REQUIRE(sheet.result() != nullptr);
  REQUIRE(!sheet.result()->alternatives.empty());
  auto* first = hand.viewport().findChild<QToolButton*>("perspective-alternative-1");
  REQUIRE(first != nullptr);
  REQUIRE(first->isVisible());
  const QImage before = hand.picture();
  QEnterEvent enter(QPointF(3, 3), QPointF(3, 3), QPointF(3, 3));
  QCoreApplication::sendEvent(first, &enter);
  const QImage shown = hand.picture();
  for (const int view : {app::SketchView, app::PerspectiveView}) {
    const QRectF rect = hand.viewport().pane(view).rect;
    const auto is_hatch = [](const QColor& color) { return color.blue() > color.red() + 60 && color.blue() > 190; };
    CHECK(share_of_pixels(shown, rect, is_hatch) > share_of_pixels(before, rect, is_hatch) + 0.005);
  }
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(first, &leave);

  const auto face_sets = [&] {
    std::set<std::set<std::string>> faces;
    for (const PerspectiveFace& face : sheet.result()->faces)
      faces.insert({face.strokes[0].begin(), face.strokes[0].end()});
    return faces;
  };
  const auto old_faces = face_sets();
  std::set<std::set<std::string>> wanted;
  for (const PerspectiveFace& face : sheet.result()->alternatives[0].faces)
    wanted.insert({face.strokes[0].begin(), face.strokes[0].end()});
  first->click();
  hand.settle();
  CHECK(face_sets() == wanted);
  CHECK(sheet.result()->alternatives.empty());
  hand.act("undo");
  hand.settle();
  CHECK(face_sets() == old_faces);
}

TEST_CASE("undo after each reconstruction restores the drawing byte for byte", "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, plain(bottle()));
  const auto bytes = [&] { return write_perspective_svg(sheet.drawing()); };
  std::vector<std::string> states = {bytes()};
  PerspectiveTool& tool = sheet.tool;
  const std::vector<std::function<void()>> edits = {
      [&] {
        tool.take(recorded::SheetDrag{sheet.drawing().strokes[8].id, 0, {7.25, -3.5}});
      },
      [&] { tool.take(recorded::SheetDelete{{sheet.drawing().strokes[10].id}}); },
      [&] {
        tool.take(recorded::SheetAim{0, {4000, 200}});
      },
      [&] {
        tool.take(recorded::SheetLength{sheet.drawing().strokes[12].id, 40.0});
      },
      [&] { tool.take(recorded::SheetUnit{"cm"}); },
      [&] {
        tool.take(recorded::SheetStroke{{{300, 300}, {350, 320}, {420, 350}}, {}, StrokeRole::Edge, false, 1, {}});
      },
  };
  for (const auto& edit : edits) {
    edit();
    hand.settle();
    states.push_back(bytes());
    CHECK(states.back() != states[states.size() - 2]);
  }
  for (std::size_t i = edits.size(); i-- > 0;) {
    hand.act("undo");
    hand.settle();
    CHECK(bytes() == states[i]);
  }
}

TEST_CASE("dragging an end updates the solid meanwhile, and Escape leaves everything as it was", "[perspective-pen]") {
  StudioFixture hand;
  app::Sheet& sheet = open_sheet(hand, plain(bottle()));
  hand.act("select");
  hand.viewport().setFocus();
  const std::string before = write_perspective_svg(sheet.drawing());
  const auto volume = [&] { return sheet.result()->network.vertices.front(); };
  const Vec3 start = volume();
  const std::string id = sheet.result()->network.curves.front().id;
  sheet.tool.select({id});
  hand.picture();
  const Vec2 end = find_stroke(sheet.drawing(), id)->start();
  const QPointF from = on_screen(hand, end);
  hand.send_mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::NoModifier);
  for (int k = 1; k <= 8; ++k)
    hand.send_mouse(QEvent::MouseMove, from + QPointF(2.0 * k, -1.0 * k), Qt::LeftButton, Qt::NoModifier);
  CHECK(hand.wait_for([&] { return (volume() - start).norm() > 1e-6; }));
  CHECK(write_perspective_svg(sheet.drawing()) != before);
  hand.act("deselect");
  CHECK(write_perspective_svg(sheet.drawing()) == before);
  hand.send_mouse(QEvent::MouseButtonRelease, from, Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  CHECK(write_perspective_svg(sheet.drawing()) == before);
  CHECK((volume() - start).norm() < 1e-9);
}

TEST_CASE("letters of sixty strokes don't cover each other", "[perspective-pen]") {
  PerspectiveDrawing drawing = plain(camera_body());
  const PerspectiveDrawing second = plain(bottle());
  for (PerspectiveStroke stroke : second.strokes) {
    stroke.id = "b" + stroke.id;
    drawing.strokes.push_back(stroke);
  }
  REQUIRE(drawing.strokes.size() >= 60);
  for (const double unit : {0.5, 1.0, 2.0}) {
    const std::vector<app::GroupLetter> letters = app::group_letters(drawing, unit);
    double nearest = 1e300;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      for (std::size_t k = i + 1; k < letters.size(); ++k)
        nearest = std::min(nearest, (letters[i].at - letters[k].at).norm());
    }
    INFO(unit);
    CHECK(nearest >= 16 * unit);
    CHECK(letters.size() * 2 > drawing.strokes.size());
  }
}

}  // namespace
}  // namespace croquis::test
