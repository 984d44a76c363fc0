// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/recording.h"
#include "support/meshes/mesh_shapes.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;
using Kind = PenStep::Kind;

constexpr Modifiers plain{};
constexpr Modifiers shift{true, false, false, false};
constexpr Modifiers ctrl{false, true, false, false};

Document document_with(PolyMesh mesh) {
  Node node;
  node.name = "body";
  node.source = std::make_shared<const PolyMesh>(std::move(mesh));
  return Document().with(std::move(node));
}

/// A mesh before a camera, and a hand.
struct Desk {
  Session session;
  MeshTool tool{session};
  TestCamera camera;
  double clock = 0;
  std::vector<recorded::Step> steps;

  explicit Desk(PolyMesh mesh) : session(document_with(std::move(mesh))) {
    camera.eye = {2.6, 2.2, 4};
    tool.set_node(1);
  }

  const PolyMesh& mesh() const { return *tool.editable().mesh(); }
  const Elements& selected() const { return session.components().elements; }

  Verdict send(Kind kind, const Vec2& pixel, const Modifiers& modifiers) {
    clock += 0.01;
    const Verdict verdict = tool.handle({kind, pixel, modifiers, camera.frame(), clock});
    if (verdict == Verdict::Commit && tool.done()) steps.push_back(*tool.done());
    return verdict;
  }

  Verdict drag(const Vec2& from, const Vec2& to, const Modifiers& modifiers = plain) {
    clock += 1;
    send(Kind::Begin, from, modifiers);
    for (int i = 1; i <= 8; ++i) send(Kind::Sample, from + (to - from) * i / 8, modifiers);
    return send(Kind::End, to, modifiers);
  }

  Verdict click(const Vec3& place, const Modifiers& modifiers = plain) {
    clock += 1;
    send(Kind::Begin, camera.pixel_of(place), modifiers);
    return send(Kind::End, camera.pixel_of(place), modifiers);
  }

  Verdict double_click(const Vec3& place, const Modifiers& modifiers = plain) {
    click(place, modifiers);
    send(Kind::Begin, camera.pixel_of(place), modifiers);
    return send(Kind::End, camera.pixel_of(place), modifiers);
  }

  Vec3 middle(ComponentKind kind, Index element) {
    const Elements vertices =
        converted(*tool.editable().topology(), kind, ComponentKind::Vertex, std::span(&element, 1));
    Vec3 sum = Vec3::Zero();
    for (const Index v : vertices) sum += mesh().positions[v];
    return sum / static_cast<double>(vertices.size());
  }

  Index vertex_at(const Vec3& place) const {
    for (Index v = 0; v < mesh().vertex_count(); ++v)
      if ((mesh().positions[v] - place).norm() < 1e-9) return v;
    return no_index;
  }
};

/// Replays what was recorded into a fresh session.
PolyMesh replayed(const PolyMesh& start, const std::vector<recorded::Step>& steps) {
  Desk desk(start);
  for (const recorded::Step& step : steps) {
    const recorded::Step read =
        recorded::parse(recorded::to_line(step), "recording", recorded::all_steps()).front().step;
    desk.tool.take(read);
  }
  return desk.mesh();
}

void check_same(const PolyMesh& a, const PolyMesh& b) {
  REQUIRE(a.vertex_count() == b.vertex_count());
  CHECK(a.corners == b.corners);
  CHECK(a.tags == b.tags);
  for (std::size_t v = 0; v < a.vertex_count(); ++v) CHECK((a.positions[v] - b.positions[v]).norm() < 1e-12);
}

TEST_CASE("clicks replace, toggle, add and remove; a click beside lets go") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Vertex);
  CHECK(desk.click({1, 1, 1}) == Verdict::Commit);
  CHECK(desk.selected() == Elements{desk.vertex_at({1, 1, 1})});
  desk.click({1, 0, 1});
  CHECK(desk.selected() == Elements{desk.vertex_at({1, 0, 1})});
  desk.click({1, 1, 1}, shift);
  desk.click({0, 1, 1}, shift);
  CHECK(desk.selected().size() == 3);
  desk.click({1, 1, 1}, shift);
  CHECK(desk.selected().size() == 2);
  desk.click({0, 1, 1}, ctrl);
  CHECK(desk.selected() == Elements{desk.vertex_at({1, 0, 1})});
  desk.click({0, 1, 1}, Modifiers{true, true, false, false});
  CHECK(desk.selected().size() == 2);
  CHECK(desk.click({9, 9, -9}, shift) == Verdict::Continue);
  CHECK(desk.selected().size() == 2);
  desk.click({9, 9, -9});
  CHECK(desk.selected().empty());
  CHECK_FALSE(desk.session.can_undo());
}

TEST_CASE("hidden elements are picked only when asked for") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Vertex);
  CHECK(desk.click({0, 0, 0}) == Verdict::Continue);
  desk.tool.set_pick_through(true);
  desk.click({0, 0, 0});
  CHECK(desk.selected() == Elements{desk.vertex_at({0, 0, 0})});
}

TEST_CASE("all, none and the rest of a selection") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Edge);
  CHECK(desk.tool.selection().select_all() == Verdict::Commit);
  CHECK(desk.selected().size() == 12);
  const auto all = *desk.tool.done()->as<recorded::Pick>();
  CHECK(all.elements.empty());
  CHECK(desk.tool.selection().select_all() == Verdict::Continue);
  desk.tool.selection().select_none();
  CHECK(desk.selected().empty());
  desk.tool.selection().pick(ComponentKind::Edge, {1, 4});
  desk.tool.selection().reselect(Reselect::Invert);
  CHECK(desk.selected().size() == 10);
  desk.tool.take(all);
  CHECK(desk.selected().size() == 12);
  desk.tool.selection().set_mode(MeshMode::Object);
  CHECK(desk.tool.selection().select_all() == Verdict::Continue);
}

TEST_CASE("a box takes what it shows") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Face);
  CHECK(desk.drag({1, 1}, {799, 599}) == Verdict::Commit);
  CHECK(desk.selected().size() == 3);
  desk.tool.set_pick_through(true);
  desk.drag({1, 1}, {799, 599});
  CHECK(desk.selected().size() == 6);
  desk.drag({1, 1}, {799, 599}, ctrl);
  CHECK(desk.selected().empty());
}

TEST_CASE("a double click on an edge takes its loop, with Shift the way from the last one") {
  Desk desk(test::torus(16, 8));
  desk.camera.eye = {0.5, 1, 5};
  desk.tool.selection().set_mode(MeshMode::Edge);
  const MeshTopology& topology = *desk.tool.editable().topology();
  // An edge on the upper side that runs around the axis.
  Index along = no_index;
  Index further = no_index;
  for (Index edge = 0; edge < topology.edge_count() && further == no_index; ++edge) {
    const Elements loop = edge_loop(topology, edge, true);
    if (loop.size() != 16 || desk.middle(ComponentKind::Edge, edge).z() < 0.35) continue;
    along = edge;
    const auto place = std::find(loop.begin(), loop.end(), edge) - loop.begin();
    further = loop[static_cast<std::size_t>((place + 3) % 16)];
  }
  REQUIRE(further != no_index);
  CHECK(desk.double_click(desk.middle(ComponentKind::Edge, along)) == Verdict::Commit);
  CHECK(desk.selected() == edge_loop(topology, along));
  desk.double_click(desk.middle(ComponentKind::Edge, along), ctrl);
  CHECK(desk.selected().empty());
  desk.click(desk.middle(ComponentKind::Edge, along));
  desk.double_click(desk.middle(ComponentKind::Edge, further), shift);
  CHECK(desk.selected().size() == 4);
  CHECK(desk.steps.back().as<recorded::Pick>()->how == "path");
}

TEST_CASE("modes keep their selections, and convert them when asked") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Face);
  desk.tool.selection().pick(ComponentKind::Face, {0});
  desk.tool.selection().set_mode(MeshMode::Vertex);
  CHECK(desk.selected().empty());
  desk.tool.selection().pick(ComponentKind::Vertex, {1, 2});
  desk.tool.selection().set_mode(MeshMode::Face);
  CHECK(desk.selected() == Elements{0});
  CHECK(desk.session.components().kind == ComponentKind::Face);
  desk.tool.selection().convert_to(MeshMode::Edge);
  CHECK(desk.selected().size() == 4);
  desk.tool.selection().set_mode(MeshMode::Object);
  CHECK(desk.selected().empty());
  desk.tool.selection().set_mode(MeshMode::Edge);
  CHECK(desk.selected().size() == 4);
}

TEST_CASE("dragging the manipulator moves what is selected as one step, and undo brings all back") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Face);
  desk.tool.set_handles(MeshHandles::Move);
  const PolyMesh before = desk.mesh();
  desk.click({0.5, 1, 0.5});
  REQUIRE(desk.selected().size() == 1);
  const auto manipulator = desk.tool.manipulator();
  REQUIRE(manipulator);
  CHECK((manipulator->pivot - Vec3(0.5, 1, 0.5)).norm() < 1e-12);
  const double unit = 80 * desk.camera.frame().units_per_pixel(manipulator->pivot);
  const Vec3 grip = manipulator->pivot + 0.7 * unit * Vec3::UnitY();
  CHECK(desk.drag(desk.camera.pixel_of(grip), desk.camera.pixel_of(grip + Vec3(0, 0.5, 0))) == Verdict::Commit);
  for (Index v = 0; v < 8; ++v) {
    const Vec3& was = before.positions[v];
    const Vec3 expected = was.y() == 1 ? Vec3(was + Vec3(0, 0.5, 0)) : was;
    CHECK((desk.mesh().positions[v] - expected).norm() < 1e-9);
  }
  CHECK(desk.session.undo_labels() == std::vector<std::string>{"Move 1 face"});
  CHECK(desk.selected().size() == 1);
  check_same(replayed(before, desk.steps), desk.mesh());
  desk.session.undo();
  check_same(desk.mesh(), before);
  CHECK(desk.selected().size() == 1);
  desk.session.redo();
  CHECK(desk.mesh().positions != before.positions);
}

TEST_CASE("a drag given up leaves nothing behind") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Vertex);
  desk.tool.set_handles(MeshHandles::Move);
  desk.click({1, 1, 1});
  const PolyMesh before = desk.mesh();
  const Vec2 middle = desk.camera.pixel_of({1, 1, 1});
  desk.send(Kind::Begin, middle, plain);
  desk.send(Kind::Sample, middle + Vec2(30, 5), plain);
  CHECK(desk.mesh().positions != before.positions);
  CHECK(desk.tool.preview().active_handle == ManipulatorHandle::Centre);
  CHECK(desk.send(Kind::Cancel, middle, plain) == Verdict::Revert);
  CHECK(desk.mesh().positions == before.positions);
  CHECK_FALSE(desk.session.can_undo());
  CHECK(desk.selected().size() == 1);
  // Somebody else's edit ends the drag, and the rest of the gesture does nothing.
  desk.send(Kind::Begin, middle, plain);
  desk.send(Kind::Sample, middle + Vec2(30, 5), plain);
  desk.session.undo();
  CHECK(desk.send(Kind::Sample, middle + Vec2(60, 5), plain) == Verdict::Revert);
  CHECK(desk.mesh().positions == before.positions);
}

TEST_CASE("turning and scaling by hand replay to the same places") {
  for (const MeshHandles handles : {MeshHandles::Rotate, MeshHandles::Scale}) {
    Desk desk(test::torus(9, 6));
    const PolyMesh before = desk.mesh();
    desk.tool.selection().set_mode(MeshMode::Face);
    desk.tool.set_handles(handles);
    desk.tool.selection().pick(ComponentKind::Face, {3, 4, 10});
    desk.steps.push_back(*desk.tool.done());
    const Vec2 middle = desk.camera.pixel_of(desk.tool.manipulator()->pivot);
    CHECK(desk.drag(middle, middle + Vec2(50, -20)) == Verdict::Commit);
    const Vec2 again = desk.camera.pixel_of(desk.tool.manipulator()->pivot);
    desk.drag(again + Vec2(0, 96), again + Vec2(96, 0));
    CHECK(desk.mesh().positions != before.positions);
    check_same(replayed(before, desk.steps), desk.mesh());
    CHECK(desk.session.undo_labels().front() == (handles == MeshHandles::Rotate ? "Rotate 3 faces" : "Scale 3 faces"));
  }
}

TEST_CASE("in object mode there is no manipulator of elements, and presses are the window's") {
  Desk desk(test::cube());
  desk.tool.set_handles(MeshHandles::Move);
  desk.session.select({{1, ""}});
  CHECK_FALSE(desk.tool.manipulator());
  CHECK(desk.send(Kind::Begin, desk.camera.pixel_of({0.5, 0.5, 0.5}), plain) == Verdict::Continue);
  CHECK_FALSE(desk.tool.active());
}

TEST_CASE("sharpness is dragged sideways, seen at once, and one step") {
  Desk desk(test::cube());
  const PolyMesh before = desk.mesh();
  desk.tool.selection().set_mode(MeshMode::Edge);
  desk.tool.set_handles(MeshHandles::Sharpen);
  desk.double_click({1, 1, 0.5});
  desk.click({1, 0.5, 1}, shift);
  REQUIRE(desk.selected().size() == 2);
  const Vec2 on_edge = desk.camera.pixel_of({1, 1, 0.5});
  desk.send(Kind::Begin, on_edge, plain);
  desk.send(Kind::Sample, on_edge + Vec2(60, 3), plain);
  CHECK(desk.tool.preview().sharpness_change == Approx(1));
  CHECK(desk.tool.editable().edge_sharpness()[desk.selected()[0]] == Approx(1));
  desk.send(Kind::Sample, on_edge + Vec2(150, 3), plain);
  desk.send(Kind::End, on_edge + Vec2(150, 3), plain);
  for (const Index edge : desk.selected()) CHECK(desk.tool.editable().edge_sharpness()[edge] == Approx(2.5));
  CHECK(desk.session.undo_labels() == std::vector<std::string>{"Sharpen 2 edges"});
  // With Shift from anywhere, and up to infinite.
  CHECK(desk.drag({20, 20}, {620, 20}, shift) == Verdict::Commit);
  for (const Index edge : desk.selected()) CHECK(std::isinf(desk.tool.editable().edge_sharpness()[edge]));
  check_same(replayed(before, desk.steps), desk.mesh());
  // Without a selected edge under it, a plain drag is a box.
  desk.drag({1, 1}, {799, 599});
  CHECK(desk.selected().size() == 9);
  CHECK(desk.session.undo_labels().size() == 2);
}

TEST_CASE("hovering shows what a click would take, with its sharpness") {
  Desk desk(test::cube());
  desk.tool.selection().set_mode(MeshMode::Edge);
  const ViewFrame frame = desk.camera.frame();
  const Vec2 pixel = desk.camera.pixel_of({1, 1, 0.5});
  CHECK(desk.tool.hover(pixel, frame));
  REQUIRE(desk.tool.preview().hovered);
  const Index edge = desk.tool.preview().hovered->element;
  CHECK_FALSE(desk.tool.preview().hovered_sharpness);
  desk.tool.selection().pick(ComponentKind::Edge, {edge});
  desk.tool.take(recorded::Tag{.sharpness = 3.5});
  desk.tool.hover(pixel, frame);
  CHECK(desk.tool.preview().hovered_sharpness == 3.5);
  CHECK(desk.tool.leave());
  CHECK_FALSE(desk.tool.preview().hovered);
  desk.tool.set_handles(MeshHandles::Move);
  desk.tool.hover(desk.camera.pixel_of(desk.tool.manipulator()->pivot), frame);
  CHECK(desk.tool.preview().hovered_handle == ManipulatorHandle::Centre);
  CHECK_FALSE(desk.tool.preview().hovered);
  CHECK_FALSE(manipulator_picture(desk.tool, frame).lines.empty());
}

TEST_CASE("an armed loop cut shows the ring under the pointer and cuts it") {
  Desk desk(test::cube());
  const PolyMesh before = desk.mesh();
  desk.tool.selection().set_mode(MeshMode::Face);
  desk.tool.arm_loop_cut(true);
  desk.tool.hover(desk.camera.pixel_of({1, 1, 0.25}), desk.camera.frame());
  REQUIRE(desk.tool.preview().cut);
  CHECK(desk.tool.preview().cut->closed);
  CHECK(desk.tool.preview().cut->points.size() == 4);
  for (const Vec3& point : desk.tool.preview().cut->points) CHECK(point.z() == Approx(0.25).margin(1e-6));
  CHECK(desk.click({1, 1, 0.25}) == Verdict::Commit);
  CHECK(desk.mesh().vertex_count() == 12);
  CHECK(desk.mesh().face_count() == 10);
  CHECK_FALSE(desk.tool.loop_cut_armed());
  CHECK(desk.tool.selection().mode() == MeshMode::Edge);
  CHECK(desk.selected().size() == 4);
  for (const Index edge : desk.selected())
    CHECK(desk.middle(ComponentKind::Edge, edge).z() == Approx(0.25).margin(1e-6));
  check_same(replayed(before, desk.steps), desk.mesh());
  desk.session.undo();
  CHECK(desk.mesh().vertex_count() == 8);
}

TEST_CASE("extruding selects the lifted faces, deleting selects nothing; both undo") {
  Desk desk(test::cube());
  const PolyMesh before = desk.mesh();
  desk.tool.selection().set_mode(MeshMode::Face);
  desk.click({0.5, 1, 0.5});
  CHECK(desk.tool.take(recorded::Extrude{.by = {0, 2, 0}}) == Verdict::Commit);
  desk.steps.push_back(*desk.tool.done());
  CHECK(desk.mesh().face_count() == 10);
  REQUIRE(desk.selected().size() == 1);
  CHECK((desk.middle(ComponentKind::Face, desk.selected()[0]) - Vec3(0.5, 3, 0.5)).norm() < 1e-12);
  desk.tool.take(recorded::Move{.by = {0, 0, 1}});
  desk.steps.push_back(*desk.tool.done());
  CHECK(desk.tool.take(recorded::Action{"delete"}) == Verdict::Commit);
  desk.steps.push_back(*desk.tool.done());
  CHECK(desk.mesh().face_count() == 9);
  CHECK(desk.selected().empty());
  CHECK(desk.tool.take(recorded::Action{"delete"}) == Verdict::Continue);
  check_same(replayed(before, desk.steps), desk.mesh());
  CHECK(desk.session.undo_labels() == std::vector<std::string>{"Extrude 1 face", "Move 1 face", "Delete 1 face"});
  desk.session.undo();
  CHECK(desk.selected().size() == 1);
  desk.session.undo();
  desk.session.undo();
  check_same(desk.mesh(), before);
}

TEST_CASE("tags are set by selection, angle and rim; sets too; each is one step") {
  Desk desk(test::merged(test::cube(), test::translated(test::grid(2, 1), {4, 0, 0})));
  const PolyMesh before = desk.mesh();
  const auto note = [&](Verdict verdict) {
    if (verdict == Verdict::Commit) desk.steps.push_back(*desk.tool.done());
    return verdict;
  };
  CHECK(edges_sharper_than(*desk.tool.editable().topology(), desk.mesh(), 60).size() == 12);
  CHECK(note(desk.tool.take(recorded::Tag{.edges = "sharper-than", .degrees = 60, .sharpness = 2})) == Verdict::Commit);
  CHECK(note(desk.tool.take(recorded::Tag{.edges = "sharper-than", .degrees = 60, .sharpness = 2})) ==
        Verdict::Continue);
  CHECK(note(desk.tool.take(recorded::Tag{.edges = "boundary"})) == Verdict::Commit);
  CHECK(desk.mesh().tags.creases.size() == 18);
  note(desk.tool.selection().pick(ComponentKind::Edge, {0, 1}));
  note(desk.tool.take(recorded::Tag{.change = 1.5}));
  CHECK(desk.tool.editable().edge_sharpness()[0] == 3.5);
  note(desk.tool.take(recorded::TagSet{.name = "rim", .sharpness = 4}));
  note(desk.tool.take(recorded::TagSet{.how = "rename", .name = "rim", .other = "collar"}));
  note(desk.tool.take(recorded::TagSet{.how = "sharpness", .name = "collar", .sharpness = 5}));
  CHECK(desk.tool.editable().edge_sharpness()[1] == 5);
  note(desk.tool.selection().select_none());
  note(desk.tool.take(recorded::TagSet{.how = "select", .name = "collar"}));
  CHECK(desk.selected() == Elements{0, 1});
  note(desk.tool.take(recorded::Pin{}));
  CHECK(desk.mesh().tags.pins.size() == 3);
  note(desk.tool.take(recorded::TagSet{.how = "untag", .name = "collar"}));
  note(desk.tool.selection().reselect(Reselect::Tagged));
  CHECK(desk.selected().size() == 16);
  CHECK_THROWS_AS(desk.tool.take(recorded::TagSet{.how = "select", .name = "collar"}), Error);
  CHECK(desk.session.undo_labels().size() == 8);
  check_same(replayed(before, desk.steps), desk.mesh());
  while (desk.session.can_undo()) desk.session.undo();
  check_same(desk.mesh(), before);
}

TEST_CASE("the journey of the collar: loop by double click, sharp for ever") {
  Desk desk(test::torus(12, 8));
  desk.camera.eye = {0.5, 1, 5};
  desk.tool.selection().set_mode(MeshMode::Edge);
  Index edge = 0;
  while (desk.middle(ComponentKind::Edge, edge).z() < 0.39) ++edge;
  desk.double_click(desk.middle(ComponentKind::Edge, edge));
  CHECK(desk.selected().size() == 12);
  desk.tool.take(recorded::Tag{.sharpness = infinite_sharpness});
  CHECK(desk.mesh().tags.creases.size() == 12);
  CHECK(desk.session.undo_labels() == std::vector<std::string>{"Sharpen 12 edges"});
  desk.tool.selection().pick(ComponentKind::Edge, {edge});
  desk.tool.selection().reselect(Reselect::Chain);
  CHECK(desk.selected().size() == 12);
  desk.tool.take(recorded::Tag{.sharpness = 0});
  CHECK(desk.mesh().tags.empty());
}

TEST_CASE("a recorded step that doesn't fit the mesh is refused by name") {
  Desk desk(test::cube());
  CHECK_THROWS_AS(desk.tool.take(recorded::Pick{"body", "edge", {12}, "loop"}), Error);
  CHECK_THROWS_AS(desk.tool.take(recorded::LoopCut{"body", 99, 0.5}), Error);
  desk.tool.set_node(7);
  CHECK_FALSE(desk.tool.editable().mesh());
  CHECK(desk.tool.take(recorded::Move{"body", {1, 0, 0}}) == Verdict::Continue);
  CHECK_THROWS_AS(desk.tool.take(recorded::Pick{"body", "edge", {0}, "loop"}), Error);
  CHECK(desk.drag({10, 10}, {100, 100}) == Verdict::Continue);
  CHECK_FALSE(desk.tool.hover({10, 10}, desk.camera.frame()));
}

TEST_CASE("neighbourhoods are made anew only when the connectivity changes") {
  Desk desk(test::torus(9, 6));
  const auto topology = desk.tool.editable().topology();
  desk.tool.selection().pick(ComponentKind::Face, {1, 2});
  desk.tool.take(recorded::Move{.by = {0.1, 0, 0}});
  desk.tool.take(recorded::Tag{.sharpness = 2});
  CHECK(desk.tool.editable().topology() == topology);
  desk.session.undo();
  CHECK(desk.tool.editable().topology() == topology);
  desk.tool.take(recorded::LoopCut{.edge = 0, .at = 0.5});
  CHECK(desk.tool.editable().topology() != topology);
}

TEST_CASE("a big mesh is made ready beside; what can't wait waits, and both give the same") {
  const PolyMesh big = test::torus(300, 200);
  Desk waiting(big);
  // Asked at once: this waits.
  CHECK(waiting.tool.selection().pick(ComponentKind::Edge, {1234}, PickHow::Ring) == Verdict::Commit);
  CHECK(waiting.tool.editable().ready());
  Desk patient(big);
  patient.tool.selection().set_mode(MeshMode::Edge);
  const Vec2 pixel = patient.camera.pixel_of({1, 0, 0.4});
  patient.tool.hover(pixel, patient.camera.frame());  // shows nothing yet, or already something
  while (!patient.tool.editable().ready()) {
  }
  patient.tool.hover(pixel, patient.camera.frame());
  CHECK(patient.tool.preview().hovered);
  CHECK(edge_ring(*patient.tool.editable().topology(), 1234) == waiting.selected());
  // Leaving before it is ready is no trouble, and neither is a mesh that changes meanwhile.
  Desk hasty(big);
  hasty.tool.set_node(0);
  hasty.tool.set_node(1);
  Node other = *hasty.session.document().find(1);
  other.source = std::make_shared<const PolyMesh>(test::torus(301, 200));
  hasty.session.edit("another", hasty.session.document().with(other));
  CHECK(hasty.tool.editable().topology()->face_count() == 60200);
}

}  // namespace
}  // namespace croquis
