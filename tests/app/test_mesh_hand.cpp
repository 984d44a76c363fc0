// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes worked on by hand in the real window: what is held stays under the pointer, and the view stays as it is.
#include <QAction>
#include <QApplication>
#include <QPushButton>
#include <cmath>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"

using namespace croquis;
using app::Viewport;
using croquis::test::all_views;
using croquis::test::cage;
using croquis::test::centred_cube;
using croquis::test::open_mesh;
using croquis::test::StudioFixture;

namespace {

Index vertex_at(const PolyMesh& mesh, const Vec3& place) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if ((mesh.positions[v] - place).norm() < 1e-9) return v;
  }
  return no_index;
}

Vec2 pixel_of(StudioFixture& hand, const Vec3& place, int view) {
  const QPointF at = hand.viewport().model_to_widget(place, view);
  return {at.x(), at.y()};
}

/// Takes hold of an arrow of the move manipulator and pulls it along itself.
/// @return how far the arrow's tip is from where the pointer ended, pixels; none where the view shows no such arrow
std::optional<double> pull_arrow(StudioFixture& hand, Index vertex, int axis, double pixels, int view) {
  const Vec3 from = cage(hand).positions[vertex];
  const ViewFrame frame = hand.viewport().mesh().frame_of(view);
  const Vec3 tip = from + 66 * frame.units_per_pixel(from) * Vec3::Unit(axis);
  const Vec2 start = pixel_of(hand, tip, view);
  const Vec2 along = start - pixel_of(hand, from, view);
  const QRectF pane = hand.viewport().pane(view).rect.adjusted(12, 12, -12, -12);  // borders between views are dragged
  if (along.norm() < 20 || !pane.contains(QPointF(start.x(), start.y()))) return std::nullopt;
  const Vec2 wanted = start + pixels * along.normalized();
  hand.drag_pixels(QPointF(start.x(), start.y()), QPointF(wanted.x(), wanted.y()), Qt::LeftButton, Qt::NoModifier);
  const Vec3 moved = cage(hand).positions[vertex] - from;
  return (pixel_of(hand, tip + moved, view) - wanted).norm();
}

struct Look {
  glm::dvec3 eye, target;
  double height;

  friend bool operator==(const Look&, const Look&) = default;
};

std::vector<Look> looks(StudioFixture& hand) {
  std::vector<Look> all;
  for (const int view : all_views) {
    const render::Camera& camera = hand.viewport().pane(view).camera;
    all.push_back({camera.eye, camera.target, camera.height});
  }
  return all;
}

}  // namespace

TEST_CASE("the nearest corner of a cube follows its arrows, in every view", "[mesh-hand]") {
  StudioFixture hand;
  hand.window().resize(1500, 950);  // room for an arrow beside the cube
  open_mesh(hand, centred_cube(), "cube");
  hand.act("layout");
  hand.settle();
  const Vec3 corner(1, 1, 1);
  for (const int view : all_views) {
    hand.viewport().show_alone(view);
    hand.settle();
    int pulled = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double pixels : {72.0, -40.0}) {
        hand.act("edge-mode");  // or two clicks would be one double click
        hand.act("vertex-mode");
        hand.act("select");
        hand.click_model(corner, view);
        REQUIRE(hand.studio().session().components().elements.size() == 1);
        hand.act("move");
        const Index vertex = vertex_at(cage(hand), corner);
        REQUIRE(vertex != no_index);
        CAPTURE(view, axis, pixels);
        const auto missed = pull_arrow(hand, vertex, axis, pixels, view);
        if (!missed) continue;
        CHECK(*missed < 2);
        CHECK((cage(hand).positions[vertex] - corner).norm() > 0.1);
        hand.act("undo");
        hand.settle();
        ++pulled;
      }
    }
    CHECK(pulled >= 4);
  }
}

TEST_CASE("pulling, extruding and undoing leave every view as it is", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  hand.act("layout");
  hand.settle();
  const std::vector<Look> before = looks(hand);
  hand.act("face-mode");
  hand.click_model({0, 0, 1}, Viewport::PerspectiveView);
  REQUIRE(hand.studio().session().components().elements.size() == 1);
  MeshTool& tool = hand.viewport().mesh().tool();
  for (const Vec3& by : {Vec3(0, 0, 30), Vec3(0, 0, -29.9), Vec3(200, 0, 0)}) {
    hand.viewport().mesh().act([&](MeshTool& t) { return t.move_selected(by); });
    hand.settle();
    CHECK(looks(hand) == before);
  }
  hand.act("extrude");
  hand.settle();
  CHECK(looks(hand) == before);
  for (int k = 0; k < 4; ++k) hand.act("undo");
  hand.settle();
  CHECK(looks(hand) == before);
  hand.act("move");
  REQUIRE(tool.manipulator());
  const QPointF at = hand.viewport().model_to_widget(tool.manipulator()->pivot, Viewport::PerspectiveView);
  hand.drag_pixels(at, at + QPointF(150, 90), Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  CHECK((cage(hand).positions.front() - centred_cube().positions.front()).norm() < 100);
  CHECK(looks(hand) == before);
}

TEST_CASE("an object that is added is framed together with what is there", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  open_mesh(hand, test::translated(centred_cube(), {40, 0, 0}), "far");
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(40, 0, 0)}) {
    const QPointF at = hand.viewport().model_to_widget(place, Viewport::PerspectiveView);
    CHECK(hand.viewport().pane(Viewport::PerspectiveView).rect.contains(at));
  }
}

TEST_CASE("a mesh in a sketch of another size is offered to be scaled, as a step that can be undone", "[mesh-hand]") {
  StudioFixture hand;
  hand.draw({{-200, -150}, {200, -150}, {200, 150}, {-200, 150}, {-200, -150}});
  hand.settle();
  auto* offer = hand.window().findChild<QPushButton*>("scale-offer");
  REQUIRE(offer != nullptr);
  CHECK(!offer->isVisible());
  const auto size_of_cube = [&] {
    const Vec3 from = cage(hand).positions.front();
    double largest = 0;
    for (const Vec3& place : cage(hand).positions) largest = std::max(largest, (place - from).norm());
    return largest;
  };
  open_mesh(hand, centred_cube(), "cube");
  REQUIRE(offer->isVisible());
  CHECK(offer->text().startsWith("cube is "));
  CHECK(offer->text().contains("times smaller than the rest"));
  CHECK(size_of_cube() < 4);
  offer->click();
  hand.settle();
  CHECK(!offer->isVisible());
  CHECK(size_of_cube() > 400);
  CHECK(hand.studio().session().undo_labels().back() == "Scale cube to the scene");
  for (const int view : {Viewport::SketchView, Viewport::PerspectiveView}) {
    for (const Vec3& corner : cage(hand).positions) {
      CHECK(hand.viewport().pane(view).rect.contains(hand.viewport().model_to_widget(corner, view)));
    }
  }
  hand.act("undo");
  CHECK(offer->isVisible());
  CHECK(size_of_cube() < 4);
  hand.act("undo");
  CHECK(!offer->isVisible());
}

TEST_CASE("what fits the scene is not offered to be scaled", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  auto* offer = hand.window().findChild<QPushButton*>("scale-offer");
  CHECK(!offer->isVisible());
  CHECK(!hand.window().action("scale-to-scene")->isEnabled());
  open_mesh(hand, test::translated(test::scaled(centred_cube(), 5), {40, 0, 0}), "larger");
  CHECK(!offer->isVisible());
  CHECK(hand.window().action("scale-to-scene")->isEnabled());
  open_mesh(hand, test::scaled(centred_cube(), 1000), "huge");
  CHECK(offer->isVisible());
  CHECK(offer->text().contains("times larger than the rest"));
}

TEST_CASE("while the camera moves a large mesh has fewer triangles, and all when it stops", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, test::torus(500, 220), "torus");
  hand.settle();
  Viewport& viewport = hand.viewport();
  constexpr std::size_t all = 220'000;
  constexpr int view = Viewport::PerspectiveView;
  REQUIRE(hand.wait_for([&] { return viewport.triangles_drawn(view) == all; }));
  const QPointF middle = viewport.pane(view).rect.center();
  hand.send_mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::AltModifier);
  for (int k = 1; k <= 5; ++k) {
    const int before = viewport.frames();
    hand.send_mouse(QEvent::MouseMove, middle + QPointF(9 * k, 4 * k), Qt::LeftButton, Qt::AltModifier);
    REQUIRE(hand.wait_for([&] { return viewport.frames() > before; }));
    CHECK(viewport.triangles_drawn(view) < 75'000);
  }
  hand.send_mouse(QEvent::MouseButtonRelease, middle + QPointF(45, 20), Qt::LeftButton, Qt::AltModifier);
  CHECK(hand.wait_for([&] { return viewport.triangles_drawn(view) == all; }));
  // What is done to the mesh itself is seen as it is.
  hand.act("vertex-mode");
  hand.settle();
  CHECK(viewport.triangles_drawn(view) == all);
}
