// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/hole_scans.h"
#include "app/studio_fixture.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/x_pointer.h"
#include "support/perspective/solid_drawing.h"
#include "support/random.h"

namespace croquis::test {
namespace {

using app::PerspectiveDrawingTool;
using app::Sheet;

Sheet& sheet_of(StudioFixture& hand) { return hand.window().tool<PerspectiveDrawingTool>().sheet(); }

SolidDrawing drawing_of(const PerspectiveSolid& solid, int construction_lines) {
  SolidDrawingOptions options;
  options.vertex_ids = false;
  options.known = false;
  options.construction_lines = construction_lines;
  return drawn(solid, three_point_views()[1], options);
}

/// The way of a mouse along a stroke that begins and ends beside the mark, in pixels of the screen.
std::vector<QPoint> way_of(StudioFixture& hand, const PerspectiveStroke& stroke, Random& random, double miss) {
  const std::vector<Vec2> places = traced(stroke.pieces, false, 40);
  const Vec2 start(random.between(-miss, miss), random.between(-miss, miss));
  const Vec2 end(random.between(-miss, miss), random.between(-miss, miss));
  std::vector<QPoint> way;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(places.size() - 1);
    const Vec2 place = places[i] + (1 - t) * start + t * end;
    const QPoint at =
        hand.viewport().mapToGlobal(app::sketch_to_widget(hand.viewport().views(), {place.x(), -place.y()})).toPoint();
    if (way.empty() || way.back() != at) way.push_back(at);
  }
  return way;
}

/// In the order of their ids: construction lines first.
std::vector<PerspectiveStroke> in_order(std::vector<PerspectiveStroke> strokes) {
  std::ranges::sort(strokes, {}, &PerspectiveStroke::id);
  return strokes;
}

void draw_with_mouse(StudioFixture& hand, XPointer& pointer, const PerspectiveStroke& stroke, Random& random,
                     double miss) {
  const std::size_t before = sheet_of(hand).drawing().strokes.size();
  pointer.drag(way_of(hand, stroke, random, miss), 8);
  REQUIRE(hand.wait_for([&] { return sheet_of(hand).drawing().strokes.size() > before; }));
}

TEST_CASE("a box drawn with a mouse at the speed of a hand, missing by one percent, becomes a closed solid",
          "[perspective]") {
  StudioFixture hand;
  hand.act("new-perspective");
  const SolidDrawing truth = drawing_of(box(), 2);
  Random random(4);
  XPointer pointer;
  hand.act("construction");
  for (const PerspectiveStroke& stroke : in_order(truth.drawing.strokes)) {
    if (stroke.role == StrokeRole::Construction) draw_with_mouse(hand, pointer, stroke, random, 3);
  }
  hand.act("construction");
  for (const PerspectiveStroke& stroke : in_order(truth.drawing.strokes)) {
    if (stroke.role == StrokeRole::Construction) continue;
    hand.act(QString("group-") + "xyz"[axis_of(stroke.group)]);
    draw_with_mouse(hand, pointer, stroke, random, 10);
  }
  hand.settle();
  const PerspectiveResult* result = sheet_of(hand).result();
  REQUIRE(result != nullptr);
  CHECK(result->closed);
  CHECK(result->faces.size() == 6);
  CHECK(result->network.vertices.size() == 8);
  hand.picture();
  const auto* faces = hand.viewport().findChild<QToolButton*>("perspective-faces");
  REQUIRE(faces != nullptr);
  CHECK(faces->text() == "Solid closed");

  hand.act("undo");
  hand.settle();
  CHECK(sheet_of(hand).result()->faces.size() < 6);
}

TEST_CASE("looked through, every vertex is seen where it was drawn, and turning the view leaves", "[perspective]") {
  for (const View& view : {three_point_views()[0], off_centre_view(), level_view()}) {
    const PerspectiveSolid solid = bottle();
    const SolidDrawing truth = drawn(solid, view);
    StudioFixture hand;
    app::start_with(hand.studio(), truth.drawing);
    app::show_views(hand.window());
    hand.settle();
    REQUIRE(sheet_of(hand).result() != nullptr);
    REQUIRE(hand.window().action("look-through")->isChecked());
    hand.picture();
    const app::ViewPane& pane = hand.viewport().pane(app::PerspectiveView);
    const Affine3 placement = upright_placement();
    const double scale =
        0.96 * std::min(pane.rect.width() / view.image_size.x(), pane.rect.height() / view.image_size.y());
    double worst = 0;
    for (const Vec3& vertex : sheet_of(hand).result()->network.vertices) {
      const QPointF seen =
          app::model_to_widget(hand.viewport().views(), placement(vertex), app::PerspectiveView) - pane.rect.center();
      const Vec2 sheet = sheet_of(hand).result()->camera.project(vertex) - truth.drawing.centre();
      worst = std::max({worst, std::abs(seen.x() - scale * sheet.x()), std::abs(seen.y() - scale * sheet.y())});
    }
    INFO(view.name);
    CHECK(worst < 0.01);
    const QPointF middle = pane.rect.center();
    hand.drag_pixels(middle, middle + QPointF(60, 20), Qt::LeftButton, Qt::AltModifier);
    CHECK_FALSE(hand.window().action("look-through")->isChecked());
    hand.act("look-through");
    CHECK(hand.window().action("look-through")->isChecked());
  }
}

TEST_CASE("the solid of a drawing is exported as STEP, or the window says what to install", "[perspective]") {
  StudioFixture hand;
  app::start_with(hand.studio(), drawn(soap(), three_point_views()[0]).drawing);
  app::show_views(hand.window());
  hand.settle();
  QAction* action = hand.window().action("export-step");
  REQUIRE(action->isEnabled());
  const QString path = hand.folder() + "/soap.step";
  if (const std::string why = why_no_step(); !why.empty()) {
    action->trigger();
    CHECK(label(hand, "message") == QString::fromStdString(why));
    return;
  }
  in_dialog<QFileDialog>([&](QFileDialog& dialog) {
    dialog.findChild<QLineEdit*>()->setText(path);
    QMetaObject::invokeMethod(&dialog, "accept");
  });
  action->trigger();
  hand.settle();
  CHECK(label(hand, "message") == "Saved soap.step");
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  CHECK(bytes.startsWith("ISO-10303-21;"));
  CHECK(bytes.contains("MANIFOLD_SOLID_BREP"));
  CHECK(bytes.contains("PRODUCT('soap','soap'"));

  hand.act("new-perspective");
  hand.settle();
  CHECK(!action->isEnabled());
}

TEST_CASE("keys over the sheet choose groups, elsewhere they are those of the views", "[perspective]") {
  StudioFixture hand;
  hand.act("new-perspective");
  hand.viewport().setFocus();
  const app::ViewPane& pane = hand.viewport().pane(app::SketchView);
  hand.send_mouse(QEvent::MouseMove, pane.rect.center(), Qt::NoButton, Qt::NoModifier);
  QTest::keyClick(&hand.viewport(), Qt::Key_5);
  CHECK(sheet_of(hand).tool.group() == StrokeGroup::NormalY);
  QTest::keyClick(&hand.viewport(), Qt::Key_0);
  CHECK(!sheet_of(hand).tool.group());
  QTest::keyClick(&hand.viewport(), Qt::Key_C);
  CHECK(sheet_of(hand).tool.role() == StrokeRole::Construction);
  QTest::keyClick(&hand.viewport(), Qt::Key_E);
  CHECK(sheet_of(hand).tool.role() == StrokeRole::Edge);
  CHECK(app::tool_in(hand.viewport().views(), app::SketchView)->keys.pressed.contains(Qt::Key_4));
  hand.act("new");
  CHECK_FALSE(app::tool_in(hand.viewport().views(), app::SketchView)->keys.pressed.contains(Qt::Key_4));
}

TEST_CASE("half of a bottle is completed by the mirror, and a wrong group is fixed by the chip", "[perspective]") {
  const PerspectiveSolid solid = bottle();
  SolidDrawing truth = drawing_of(solid, 3);
  double low = 1e9, high = -1e9;
  for (const Vec3& vertex : solid.network.vertices) {
    low = std::min(low, vertex.y());
    high = std::max(high, vertex.y());
  }
  for (const NetworkCurve& curve : truth.network.curves) {
    const double nearer = std::min(truth.network.vertices[curve.start].y(), truth.network.vertices[curve.end].y());
    if (nearer > (low + high) / 2) remove_strokes(truth.drawing, {curve.id});
  }
  StudioFixture hand;
  app::start_with(hand.studio(), truth.drawing);
  app::show_views(hand.window());
  hand.settle();
  REQUIRE(sheet_of(hand).result() != nullptr);
  CHECK(sheet_of(hand).result()->faces.size() < solid.faces.size());
  hand.act("mirror");
  REQUIRE(sheet_of(hand).proposal);
  hand.picture();
  hand.viewport().findChild<QToolButton*>("perspective-mirror-chip")->click();
  hand.settle();
  CHECK(sheet_of(hand).result()->closed);
  CHECK(sheet_of(hand).result()->faces.size() == solid.faces.size());

  std::string edge;
  for (const PerspectiveStroke& stroke : sheet_of(hand).drawing().strokes) {
    if (stroke.role == StrokeRole::Edge && stroke.group == StrokeGroup::ParallelY && edge.empty()) edge = stroke.id;
  }
  StrokeSetting wrong;
  wrong.group = StrokeGroup::ParallelX;
  sheet_of(hand).tool.take(recorded::SheetSetting{{edge}, wrong});
  hand.settle();
  REQUIRE(!sheet_of(hand).result()->fixes.empty());
  hand.picture();
  hand.viewport().findChild<QToolButton*>("perspective-fix-chip")->click();
  hand.settle();
  CHECK(find_stroke(sheet_of(hand).drawing(), edge)->group == StrokeGroup::ParallelY);
  CHECK(sheet_of(hand).result()->closed);
}

}  // namespace
}  // namespace croquis::test
