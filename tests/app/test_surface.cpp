// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "app/replay/replay_player.h"
#include "app/studio_fixture.h"
#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "app/x_pointer.h"
#include "croquis/io/file.h"
#include "croquis/tools/all_steps.h"
#include "support/random.h"

namespace croquis::test {
namespace {

using app::DrawnNetwork;
using app::PerspectiveView;
using app::SurfaceDrawingTool;

SurfaceDrawingTool& tool_of(StudioFixture& hand) { return hand.window().tool<SurfaceDrawingTool>(); }
DrawnNetwork& network_of(StudioFixture& hand) { return tool_of(hand).network(); }
const AttributeNetwork& drawn(StudioFixture& hand) { return network_of(hand).network(); }

const SurfaceResult& result_of(StudioFixture& hand) {
  REQUIRE(network_of(hand).shown);
  return *network_of(hand).shown.found;
}

/// Pictures for people who want to look: CROQUIS_SHOTS names their folder.
void shoot(StudioFixture& hand, const QString& name) {
  const QString folder = qEnvironmentVariable("CROQUIS_SHOTS");
  if (folder.isEmpty()) return;
  hand.settle();
  app::settle(hand.viewport().pictures(), true);
  QApplication::processEvents();
  hand.window().grab().save(folder + "/" + name + ".png");
}

void open_network(StudioFixture& hand, const QString& name) {
  REQUIRE(hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/surface/" + name + ".json"));
  hand.settle();
}

QPoint on_screen(StudioFixture& hand, const QPointF& widget) { return hand.viewport().mapToGlobal(widget).toPoint(); }

QPointF seen(StudioFixture& hand, const Vec3& world) {
  return app::model_to_widget(hand.viewport().views(), world, PerspectiveView);
}

/// A hand's way between two places of the screen: bent sideways, shaking by a pixel, and missing both ends.
std::vector<QPoint> way_of_hand(StudioFixture& hand, const QPointF& from, const QPointF& to, double bend,
                                Random& random) {
  constexpr int events = 60;
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  const QPointF aside(-along.y() / length, along.x() / length);
  const double miss = std::min(0.02 * length, 7.0);
  const auto shake = [&](double by) { return QPointF(random.between(-by, by), random.between(-by, by)); };
  const QPointF start = shake(miss), end = shake(miss);
  std::vector<QPoint> way;
  for (int k = 0; k <= events; ++k) {
    const double t = static_cast<double>(k) / events;
    const QPointF place = from + t * along + 4 * t * (1 - t) * bend * aside + (1 - t) * start + t * end + shake(0.7);
    const QPoint at = on_screen(hand, place);
    if (way.empty() || way.back() != at) way.push_back(at);
  }
  return way;
}

/// Half a second.
void stroke(StudioFixture& hand, XPointer& pointer, const std::vector<QPoint>& way, const std::function<bool()>& done) {
  pointer.drag(way, 8);
  REQUIRE(hand.wait_for(done));
  hand.settle();
}

/// Three curves on the ground, drawn by a hand: a long triangle.
void draw_three_curves(StudioFixture& hand, XPointer& pointer) {
  hand.act("new-surface");
  hand.settle();
  Random random(7);
  const std::array<Vec3, 3> corners{Vec3(-170, 0, 70), Vec3(170, 0, 60), Vec3(130, 0, -60)};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto way = way_of_hand(hand, seen(hand, corners[k]), seen(hand, corners[(k + 1) % 3]), 14, random);
    stroke(hand, pointer, way, [&] { return drawn(hand).curves.size() > k; });
  }
}

void box_select(StudioFixture& hand, XPointer& pointer) {
  hand.act("select");
  const QRectF& pane = hand.viewport().pane(PerspectiveView).rect;
  const QPoint low = on_screen(hand, pane.topLeft() + QPointF(30, 60));
  const QPoint high = on_screen(hand, pane.bottomRight() - QPointF(60, 60));
  std::vector<QPoint> way;
  for (int k = 0; k <= 20; ++k) way.push_back(low + (high - low) * k / 20);
  pointer.drag(way, 8);
  REQUIRE(hand.wait_for([&] { return !network_of(hand).tool.selected().curves.empty(); }));
}

/// The middle of the first patch as it would be without points, in the world.
Vec3 middle_of_patch(StudioFixture& hand) {
  const SurfaceResult& result = result_of(hand);
  const FaceSurface& face = *result.surface->faces[0].surface;
  return network_of(hand).to_world()(face.base_at(face.domain().centroid));
}

TEST_CASE(
    "three curves drawn by hand and selected by a box become a patch; a point, a comparison, an inner curve and "
    "a file follow",
    "[surface]") {
  StudioFixture hand;
  XPointer pointer;
  draw_three_curves(hand, pointer);
  CHECK(drawn(hand).curves.size() == 3);
  CHECK(drawn(hand).nodes.size() == 3);
  shoot(hand, "1-curves");

  box_select(hand, pointer);
  CHECK(network_of(hand).tool.selected().curves.size() == 3);
  hand.picture();
  CHECK(hand.viewport().findChild<QToolButton*>("patch-chip")->isVisible());
  shoot(hand, "2-selected");
  QTest::keyClick(&hand.viewport(), Qt::Key_Return);
  hand.settle();
  REQUIRE(drawn(hand).faces.size() == 1);
  CHECK(result_of(hand).measures.boundary_error < 1e-9 * 400);
  shoot(hand, "3-patch");

  hand.act("surface-point");
  const QPointF middle = seen(hand, middle_of_patch(hand));
  std::vector<QPoint> pull;
  for (int k = 0; k <= 30; ++k) pull.push_back(on_screen(hand, middle - QPointF(0, 3 * k)));
  const std::size_t steps = hand.studio().session().undo_labels().size();
  stroke(hand, pointer, pull, [&] { return !drawn(hand).points.empty() && !tool_of(hand).down(); });
  REQUIRE(drawn(hand).points.size() == 1);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK(drawn(hand).points[0].point.z() > 20);
  REQUIRE(result_of(hand).measures.point_errors[0]);
  CHECK(*result_of(hand).measures.point_errors[0] < 1e-9 * 400);
  hand.act("select");
  hand.settle();
  shoot(hand, "4-point");

  QTest::keyClick(&hand.viewport(), Qt::Key_U);
  hand.settle();
  const auto* compared = tool_of(hand).ghost().compared();
  REQUIRE(compared != nullptr);
  REQUIRE(compared->comparison.points.size() == 1);
  CHECK(compared->comparison.points[0].own->offset < compared->comparison.points[0].uniform->offset);
  CHECK(hand.window().findChild<QLabel*>("domain-numbers")->text().contains("uniform"));
  CHECK(hand.window().findChild<app::DomainView*>("domain-view")->uniform());
  shoot(hand, "5-uniform");
  QTest::keyClick(&hand.viewport(), Qt::Key_U);
  hand.settle();
  CHECK(tool_of(hand).ghost().compared() == nullptr);

  hand.act("inner-curve");
  const QPointF from = seen(hand, middle_of_patch(hand)) + QPointF(-130, 6);
  Random random(3);
  stroke(hand, pointer, way_of_hand(hand, from, from + QPointF(80, 14), 6, random),
         [&] { return drawn(hand).curves.size() == 4; });
  REQUIRE(drawn(hand).faces[0].inner.size() == 1);
  shoot(hand, "6-inner");
  const QString path = hand.folder() + "/bonnet.glb";
  app::export_solid(hand.studio(), path);
  CHECK(QFile(path).size() > 1000);
}

TEST_CASE("a click inside a loop makes a patch of it, and a loop that isn't closed says where it is open",
          "[surface]") {
  StudioFixture hand;
  XPointer pointer;
  draw_three_curves(hand, pointer);
  QPointF middle;
  for (const AttributeNode& node : drawn(hand).nodes) middle += seen(hand, network_of(hand).to_world()(node.point)) / 3;
  QTest::keyClick(&hand.viewport(), Qt::Key_P);
  CHECK(hand.viewport().views().mode == "patch");
  hand.send_mouse(QEvent::MouseMove, middle, Qt::NoButton, Qt::NoModifier);
  CHECK(network_of(hand).tool.preview().loop);
  hand.drag_pixels(middle, middle, Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  CHECK(drawn(hand).faces.size() == 1);

  hand.act("undo");
  hand.settle();
  network_of(hand).act(recorded::SurfaceDelete{{{}, {drawn(hand).curves[1].id}, {}, {}}});
  box_select(hand, pointer);
  hand.picture();
  const auto* gap = hand.viewport().findChild<QLabel*>("gap-chip");
  CHECK(gap->isVisible());
  CHECK(gap->text().startsWith("Gap of"));
  shoot(hand, "7-gap");
}

TEST_CASE("the crashed car opens upright with all of its patches, and names the joins of its smooth curves",
          "[surface]") {
  StudioFixture hand;
  open_network(hand, "car_crashed");
  const SurfaceResult& result = result_of(hand);
  CHECK(std::ranges::all_of(result.surface->faces, [](const SurfaceFace& face) { return face.surface != nullptr; }));
  CHECK(result.surface->faces.size() == 21);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& place : network_of(hand).shown.mesh->positions) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const Vec3 size = high - low;
  CHECK(size.y() < size.x());
  CHECK(size.y() < size.z());
  shoot(hand, "8-car");
  QTest::keyClick(&hand.viewport(), Qt::Key_J);
  hand.picture();
  CHECK(network_of(hand).scene.numbers().size() == 17);
  shoot(hand, "9-jumps");
  QTest::keyClick(&hand.viewport(), Qt::Key_J);
  hand.act("zebra");
  shoot(hand, "10-zebra");
  hand.act("zebra");
}

TEST_CASE("a point picked in a view is moved by its numbers in the panel, and its domain is shown", "[surface]") {
  StudioFixture hand;
  open_network(hand, "tri_point");
  const Vec3 before = drawn(hand).points[0].point;
  const QPointF at = seen(hand, network_of(hand).to_world()(before));
  hand.drag_pixels(at, at, Qt::LeftButton, Qt::NoModifier);
  REQUIRE(network_of(hand).tool.selected().points.size() == 1);
  shoot(hand, "11-ring");
  auto* height = hand.window().findChild<QDoubleSpinBox*>("surface-point-z");
  REQUIRE(height->value() == Approx(before.z()));
  height->setValue(0.7);
  hand.settle();
  CHECK(drawn(hand).points[0].point.z() == Approx(0.7));
  CHECK(drawn(hand).points[0].point.x() == before.x());
  CHECK(hand.studio().session().undo_labels().size() == 1);
  const auto& domain = hand.window().findChild<app::DomainView*>("domain-view")->own();
  REQUIRE(domain);
  CHECK(domain->polygon.corners.size() == 3);
  REQUIRE(domain->points.size() == 1);
  CHECK(domain->points[0].selected);
  auto* radius = hand.window().findChild<QDoubleSpinBox*>("surface-radius");
  radius->setValue(0.2);
  hand.settle();
  CHECK(*drawn(hand).points[0].radius == Approx(0.2));
  auto* fullness = hand.window().findChild<QDoubleSpinBox*>("surface-fullness");
  fullness->setValue(0.3);
  hand.settle();
  CHECK(drawn(hand).faces[0].fullness == Approx(0.3));
  hand.act("undo");
  hand.act("undo");
  hand.act("undo");
  CHECK(drawn(hand).points[0].point == before);
}

TEST_CASE("while a point is dragged its patch follows, and Escape takes all back", "[surface]") {
  StudioFixture hand;
  open_network(hand, "tri_point");
  const Vec3 before = drawn(hand).points[0].point;
  const QPointF at = seen(hand, network_of(hand).to_world()(before));
  hand.drag_pixels(at, at, Qt::LeftButton, Qt::NoModifier);
  hand.send_mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::NoModifier);
  for (int k = 1; k <= 10; ++k)
    hand.send_mouse(QEvent::MouseMove, at + QPointF(0, 4 * k), Qt::LeftButton, Qt::NoModifier);
  const Vec3 dragged = drawn(hand).points[0].point;
  CHECK((dragged - before).norm() > 0.01);
  const bool followed = hand.wait_for([&] {
    const app::ShownSurface& shown = network_of(hand).shown;
    return shown && (shown.network().points[0].point - dragged).norm() < 1e-9;
  });
  CHECK(followed);
  hand.act("deselect");  // Escape
  hand.settle();
  CHECK(drawn(hand).points[0].point == before);
  CHECK(hand.studio().session().undo_labels().empty());
}

TEST_CASE("a curve is made smooth and a crease again by a key, split and merged by the menu", "[surface]") {
  StudioFixture hand;
  open_network(hand, "car_intact");
  const auto choose = [&](const std::string& curve) {
    network_of(hand).act(recorded::SurfaceChoice{{{}, {curve}, {}, {}}});
    return find_element(drawn(hand), NetworkElement::Curve, curve);
  };
  const Index crease = static_cast<Index>(
      std::ranges::find(drawn(hand).curves, CurveJoin::Crease, &AttributeCurve::join) - drawn(hand).curves.begin());
  const std::string id = drawn(hand).curves[crease].id;
  choose(id);
  shoot(hand, "12-curve");
  QTest::keyClick(&hand.viewport(), Qt::Key_S);
  CHECK(drawn(hand).curves[crease].join == CurveJoin::Smooth);
  QTest::keyClick(&hand.viewport(), Qt::Key_S);
  CHECK(drawn(hand).curves[crease].join == CurveJoin::Crease);
  const std::size_t curves = drawn(hand).curves.size();
  hand.act("split-element");
  CHECK(drawn(hand).curves.size() == curves + 1);
  hand.act("undo");
  Index between = 0;
  while (!can_merge_faces(drawn(hand), between)) ++between;
  choose(drawn(hand).curves[between].id);
  hand.settle();
  const std::size_t faces = drawn(hand).faces.size();
  REQUIRE(hand.window().action("merge-patches")->isEnabled());
  hand.act("merge-patches");
  CHECK(drawn(hand).faces.size() == faces - 1);
}

TEST_CASE("what a hand does to a network is recorded, and a recording makes the same network again", "[surface]") {
  const QTemporaryDir folder;
  const std::string path = (folder.path() + "/hand.jsonl").toStdString();
  StudioFixture hand;
  hand.window().record_to(QString::fromStdString(path));
  XPointer pointer;
  draw_three_curves(hand, pointer);
  box_select(hand, pointer);
  QTest::keyClick(&hand.viewport(), Qt::Key_Return);
  hand.settle();
  hand.act("surface-point");
  const QPointF middle = seen(hand, middle_of_patch(hand));
  hand.drag_pixels(middle, middle - QPointF(0, 60), Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  REQUIRE(drawn(hand).points.size() == 1);

  StudioFixture again;
  app::play(again.window(), recorded::parse(read_file(path), path, recorded::all_steps()));
  again.settle();
  REQUIRE(drawn(again).nodes.size() == drawn(hand).nodes.size());
  REQUIRE(drawn(again).curves.size() == drawn(hand).curves.size());
  REQUIRE(drawn(again).faces.size() == 1);
  REQUIRE(drawn(again).points.size() == 1);
  for (Index node = 0; node < drawn(hand).nodes.size(); ++node)
    CHECK((drawn(again).nodes[node].point - drawn(hand).nodes[node].point).norm() < 1e-3);
  CHECK((drawn(again).points[0].point - drawn(hand).points[0].point).norm() < 1e-3);
}

TEST_CASE("a patch that can't be made stays as a loop, the others are made, and the chip over the view shows where",
          "[surface]") {
  StudioFixture hand;
  open_network(hand, "car_intact");
  AttributeNetwork broken = drawn(hand);
  const Index hood = find_element(broken, NetworkElement::Face, "hood");
  broken.faces[hood].loop[0].reversed = !broken.faces[hood].loop[0].reversed;
  app::start_with(hand.studio(), broken, "broken");
  app::show_views(hand.window());
  hand.settle();
  CHECK(!result_of(hand).surface->faces[hood].surface);
  CHECK(std::ranges::count_if(result_of(hand).surface->faces,
                              [](const SurfaceFace& face) { return face.surface != nullptr; }) == 20);
  hand.picture();
  auto* chip = hand.viewport().findChild<QToolButton*>("network-state");
  REQUIRE(chip->isVisible());
  CHECK(chip->text().startsWith("1 patch can't be made"));
  shoot(hand, "13-broken");
  chip->click();
  CHECK(!network_of(hand).tool.selected().empty());
  CHECK(network_of(hand).scene.marks().size() >= 1);
}

TEST_CASE("curves are taken from the edges of a mesh, to be worked on", "[surface]") {
  StudioFixture hand;
  PolyMesh tray = cube();
  tray.corners.resize(tray.corners.size() - tray.face(static_cast<Index>(tray.face_count() - 1)).size());
  tray.face_offsets.pop_back();
  open_mesh(hand, tray, "tray");
  REQUIRE(hand.window().action("curves-by-edge_network")->isEnabled());
  hand.act("curves-by-edge_network");
  CHECK(hand.wait_for([&] { return hand.studio().network_node() != 0; }));
  hand.settle();
  CHECK(drawn(hand).curves.size() == 4);
  const auto& positions = tray.positions;
  double farthest = 0;  // curves lie where the mesh does
  for (const AttributeNode& node : drawn(hand).nodes) {
    double nearest = 1e300;
    for (const Vec3& place : positions)
      nearest = std::min(nearest, (network_of(hand).to_world()(node.point) - place).norm());
    farthest = std::max(farthest, nearest);
  }
  CHECK(farthest < 1e-6);
  CHECK(hand.studio().session().undo_labels().back() == "Take curves");
  shoot(hand, "14-taken");
}

}  // namespace
}  // namespace croquis::test
