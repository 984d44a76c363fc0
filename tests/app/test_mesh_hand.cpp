// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes worked on by hand in the real window: what is held stays under the pointer, and the view stays as it is.
#include <QAction>
#include <QApplication>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "support/scans/scans.h"

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
  const QPointF at = app::model_to_widget(hand.viewport().views(), place, view);
  return {at.x(), at.y()};
}

/// A drag of a few events before anything is drawn: frames of large views are slow without a graphics card.
void drag_at_once(StudioFixture& hand, const Vec2& from, const Vec2& to) {
  const auto at = [&](double part) {
    const Vec2 place = from + part * (to - from);
    return QPointF(place.x(), place.y());
  };
  hand.send_mouse(QEvent::MouseButtonPress, at(0), Qt::LeftButton, Qt::NoModifier);
  for (const double part : {0.25, 0.5, 0.75, 1.0})
    hand.send_mouse(QEvent::MouseMove, at(part), Qt::LeftButton, Qt::NoModifier);
  hand.send_mouse(QEvent::MouseButtonRelease, at(1), Qt::LeftButton, Qt::NoModifier);
  QApplication::processEvents();
}

constexpr std::array axis_handles = {ManipulatorHandle::X, ManipulatorHandle::Y, ManipulatorHandle::Z};

/// Takes hold of an arrow of the move manipulator and pulls it along itself.
/// @return how far the arrow's tip is from where the pointer ended, pixels; none where the view shows no such arrow
std::optional<double> pull_arrow(StudioFixture& hand, Index vertex, int axis, double pixels, int view) {
  const Vec3 from = cage(hand).positions[vertex];
  const ViewFrame frame = app::frame_of(hand.viewport().views(), view);
  const Vec3 tip = from + 66 * frame.units_per_pixel(from) * Vec3::Unit(axis);
  const Vec2 start = pixel_of(hand, tip, view);
  const Vec2 along = start - pixel_of(hand, from, view);
  const QRectF pane = hand.viewport().pane(view).rect.adjusted(12, 12, -12, -12);  // borders between views are dragged
  if (!pane.contains(QPointF(start.x(), start.y()))) return std::nullopt;
  hand.send_mouse(QEvent::MouseMove, QPointF(start.x(), start.y()), Qt::NoButton, Qt::NoModifier);
  QApplication::processEvents();
  if (hand.mesh().tool().preview().hovered_handle != axis_handles.at(static_cast<std::size_t>(axis)))
    return std::nullopt;
  const Vec2 wanted = start + pixels * along.normalized();
  drag_at_once(hand, start, wanted);
  const Vec3 moved = cage(hand).positions[vertex] - from;
  return (pixel_of(hand, tip + moved, view) - wanted).norm();
}

/// A camera near the cube [-1, 1]^3, a corner that it sees, and two places beside the corner.
struct NearView {
  Vec3 eye, target, corner;
  std::array<Vec3, 2> beside;
};

const std::array<NearView, 2> near_views{
    {{{0.1, 0.2, 0.3}, {1, 0.6, -0.9}, {1, 1, -1}, {{{1, 0.75, -0.75}, {0.75, 0.75, -1}}}},
     {{1.3, 1.25, 1.5}, {0.9, 1, 0.9}, {1, 1, 1}, {{{1, 1, 0.75}, {0.75, 1, 1}}}}}};

/// Shows the perspective view alone, from there.
void look_from(StudioFixture& hand, const NearView& near) {
  hand.viewport().views().layout.show_alone(Viewport::PerspectiveView);
  render::Camera& camera = hand.viewport().pane(Viewport::PerspectiveView).camera;
  camera.eye = {near.eye.x(), near.eye.y(), near.eye.z()};
  camera.target = {near.target.x(), near.target.y(), near.target.z()};
  hand.settle();
}

/// Clicks vertices of the active cage until these are selected, and no others.
std::vector<Index> select_vertices(StudioFixture& hand, const std::vector<Vec3>& places, int view) {
  hand.act("edge-mode");  // or two clicks would be one double click
  hand.act("vertex-mode");
  hand.act("select");
  std::vector<Index> vertices;
  for (const Vec3& place : places) {
    vertices.push_back(vertex_at(cage(hand), place));
    REQUIRE(vertices.back() != no_index);
    hand.click_model(place, view, 1, vertices.size() > 1 ? Qt::ShiftModifier : Qt::NoModifier);
  }
  std::sort(vertices.begin(), vertices.end());
  REQUIRE(hand.studio().session().components().elements == vertices);
  return vertices;
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
  open_mesh(hand, centred_cube(), "cube");
  hand.act("layout");
  hand.settle();
  const Vec3 corner(1, 1, 1);
  for (const int view : all_views) {
    hand.viewport().views().layout.show_alone(view);
    render::Camera& camera = hand.viewport().pane(view).camera;
    camera = render::dolly(camera, 0.8);  // room for an arrow beside the cube
    hand.settle();
    int pulled = 0;
    const Index vertex = select_vertices(hand, {corner}, view).front();
    hand.act("move");
    for (int axis = 0; axis < 3; ++axis) {
      for (const double pixels : {72.0, -40.0}) {
        CAPTURE(view, axis, pixels);
        const auto missed = pull_arrow(hand, vertex, axis, pixels, view);
        if (!missed) continue;
        CHECK(*missed < 2);
        CHECK((cage(hand).positions[vertex] - corner).norm() > 0.1);
        hand.act("undo");
        REQUIRE(cage(hand).positions[vertex] == corner);
        ++pulled;
      }
    }
    CHECK(pulled >= 4);
  }
}

TEST_CASE("a corner follows its arrows with the camera inside the model and close to it", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  for (const NearView& near : near_views) {
    look_from(hand, near);
    const std::vector<Look> before = looks(hand);
    int pulled = 0;
    const Index vertex = select_vertices(hand, {near.corner}, Viewport::PerspectiveView).front();
    hand.act("move");
    for (int axis = 0; axis < 3; ++axis) {
      for (const double pixels : {72.0, -40.0}) {
        CAPTURE(near.eye.transpose(), axis, pixels);
        const auto missed = pull_arrow(hand, vertex, axis, pixels, Viewport::PerspectiveView);
        if (!missed) continue;
        CHECK(*missed < 2);
        const Vec3 moved = cage(hand).positions[vertex] - near.corner;
        CHECK(std::abs(moved[axis]) > 0.01);
        CHECK(moved.norm() == Approx(std::abs(moved[axis])));
        hand.act("undo");
        REQUIRE(cage(hand).positions[vertex] == near.corner);
        ++pulled;
      }
    }
    hand.settle();
    CHECK(looks(hand) == before);
    CHECK(pulled >= 2);
  }
}

TEST_CASE("several vertices rotate and scale as far as they are dragged, close to the model and inside",
          "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, test::translated(test::scaled(test::divided_box(8), 2), {-1, -1, -1}), "box");
  for (const NearView& near : near_views) {
    look_from(hand, near);
    CAPTURE(near.eye.transpose());
    const std::vector<Index> vertices =
        select_vertices(hand, {near.corner, near.beside[0], near.beside[1]}, Viewport::PerspectiveView);
    const PolyMesh before = cage(hand);
    Eigen::AlignedBox3d box(near.corner);
    for (const Vec3& place : near.beside) box.extend(place);
    const Vec3 pivot = box.center();
    const Vec2 middle = pixel_of(hand, pivot, Viewport::PerspectiveView);
    const auto offset = [&](const PolyMesh& mesh, Index vertex) { return Vec3(mesh.positions[vertex] - pivot); };

    hand.act("rotate");
    drag_at_once(hand, middle + Vec2(96, 0), middle + 96 * Vec2(std::cos(0.5), -std::sin(0.5)));  // the outer ring
    const Vec3 to_eye = (near.eye - pivot).normalized();
    const Eigen::AngleAxisd turn(0.5, to_eye);
    for (const Index vertex : vertices)
      CHECK((offset(cage(hand), vertex) - turn * offset(before, vertex)).norm() < 1e-6);
    hand.act("undo");
    REQUIRE(cage(hand).positions == before.positions);

    hand.act("scale");
    drag_at_once(hand, middle, middle + Vec2(40, 0));  // half of its arrows' length
    for (const Index vertex : vertices)
      CHECK((offset(cage(hand), vertex) - 1.5 * offset(before, vertex)).norm() < 1e-9);
    for (Index other = 0; other < before.vertex_count(); ++other) {
      if (!std::binary_search(vertices.begin(), vertices.end(), other))
        CHECK(cage(hand).positions[other] == before.positions[other]);
    }
    hand.act("undo");
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
  MeshTool& tool = hand.mesh().tool();
  for (const Vec3& by : {Vec3(0, 0, 30), Vec3(0, 0, -29.9), Vec3(200, 0, 0)}) {
    hand.mesh().act([&](MeshTool& t) { return t.take(recorded::Move{.by = by}); });
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
  // Far enough to leave the view in part.
  const QRectF pane = hand.viewport().pane(Viewport::PerspectiveView).rect.adjusted(15, 15, -15, -15);
  const Vec3 pivot = tool.manipulator()->pivot;
  const double unit = app::frame_of(hand.viewport().views(), Viewport::PerspectiveView).units_per_pixel(pivot);
  const Vec3 tip = pivot + 75 * unit * Vec3::UnitZ();  // of an arrow
  for (const auto& [place, to] : {std::pair(pivot, pane.bottomRight()), std::pair(tip, pane.bottomLeft())}) {
    const std::vector<Vec3> was = cage(hand).positions;
    drag_at_once(hand, pixel_of(hand, place, Viewport::PerspectiveView), {to.x(), to.y()});
    CHECK(looks(hand) == before);
    hand.settle();
    CHECK(looks(hand) == before);
    const std::vector<Vec3>& now = cage(hand).positions;
    REQUIRE(now.size() == was.size());
    for (std::size_t v = 0; v < now.size(); ++v) CHECK((now[v] != was[v]) == (was[v].z() > 0));
    hand.act("undo");
    REQUIRE(cage(hand).positions == was);
  }
}

TEST_CASE("an object that is added is framed together with what is there", "[mesh-hand]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  open_mesh(hand, test::translated(centred_cube(), {40, 0, 0}), "far");
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(40, 0, 0)}) {
    const QPointF at = app::model_to_widget(hand.viewport().views(), place, Viewport::PerspectiveView);
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
    const std::array<Vec3, 2> box = *placed_bounds(hand.studio(), *hand.studio().active());
    return (box[1] - box[0]).norm();
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
  const auto bounds = placed_bounds(hand.studio(), *hand.studio().active());
  REQUIRE(bounds);
  for (const int view : {Viewport::SketchView, Viewport::PerspectiveView}) {
    for (const Vec3& corner : *bounds) {
      CHECK(hand.viewport().pane(view).rect.contains(app::model_to_widget(hand.viewport().views(), corner, view)));
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
  REQUIRE(hand.wait_for([&] { return viewport.pictures().state(view).triangles == all; }));
  const QPointF middle = viewport.pane(view).rect.center();
  hand.send_mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::AltModifier);
  for (int k = 1; k <= 5; ++k) {
    const int before = viewport.pictures().frames;
    hand.send_mouse(QEvent::MouseMove, middle + QPointF(9 * k, 4 * k), Qt::LeftButton, Qt::AltModifier);
    REQUIRE(hand.wait_for([&] { return viewport.pictures().frames > before; }));
    CHECK(viewport.pictures().state(view).triangles < 45'000);
  }
  hand.send_mouse(QEvent::MouseButtonRelease, middle + QPointF(45, 20), Qt::LeftButton, Qt::AltModifier);
  CHECK(hand.wait_for([&] { return viewport.pictures().state(view).triangles == all; }));
  // What is done to the mesh itself is seen as it is.
  hand.act("vertex-mode");
  hand.settle();
  CHECK(viewport.pictures().state(view).triangles == all);
}
