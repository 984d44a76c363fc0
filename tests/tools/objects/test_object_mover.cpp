// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/tools/objects/object_mover.h"
#include "croquis/tools/recording/recording.h"
#include "support/main_loop.h"
#include "support/meshes/mesh_shapes.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using Kind = PenStep::Kind;

struct Stage {
  test::MainLoop loop;
  Workspace workspace{Registry(), loop.post(), {}};
  ObjectMover mover{workspace};
  test::TestCamera camera;
  NodeId near = 0, far = 0;

  Stage() {
    camera.eye = {3, 4, 12};
    near = add_source(workspace, "near", std::make_shared<const PolyMesh>(test::cube()));
    far = add_source(workspace, "far", std::make_shared<const PolyMesh>(test::translated(test::cube(), {3, 0, 0})));
  }

  Verdict send(Kind kind, const Vec2& pixel, const Modifiers& modifiers = {}) {
    return mover.handle({kind, pixel, modifiers, camera.frame(), 0});
  }
  Verdict drag(const Vec3& from, const Vec3& to, const Modifiers& modifiers = {}) {
    const Vec2 start = camera.pixel_of(from), end = camera.pixel_of(to);
    send(Kind::Begin, start, modifiers);
    for (int i = 1; i <= 8; ++i) send(Kind::Sample, start + (end - start) * i / 8, modifiers);
    return send(Kind::End, end, modifiers);
  }
  /// A place on the arrow of that axis.
  Vec3 grip(int axis) {
    const Manipulator now = *mover.manipulator();
    return now.pivot + 0.7 * now.pixels * camera.frame().units_per_pixel(now.pivot) * now.axes.col(axis);
  }
  Placement placement(NodeId node) { return workspace.object(node)->placement; }
  void pick(std::vector<NodeId> nodes) {
    Selection selection;
    for (const NodeId node : nodes) selection.push_back({node, ""});
    workspace.session().select(std::move(selection));
  }
};

}  // namespace

TEST_CASE("object mover: picked objects move together along an axis as one step, and undo brings them back") {
  Stage stage;
  stage.pick({stage.near, stage.far});
  CHECK_FALSE(stage.mover.manipulator());
  stage.mover.set_kind(ManipulatorKind::Move);
  REQUIRE(stage.mover.manipulator());
  CHECK((stage.mover.manipulator()->pivot - Vec3(2, 0.5, 0.5)).norm() < 1e-12);
  const auto steps = stage.workspace.session().undo_labels().size();
  const ContentHash before = content_hash(stage.workspace.session().document());
  CHECK(stage.drag(stage.grip(1), stage.grip(1) + Vec3(0, 2, 0)) == Verdict::Commit);
  CHECK((stage.placement(stage.near).position - Vec3(0, 2, 0)).norm() < 1e-6);
  CHECK((stage.placement(stage.far).position - Vec3(0, 2, 0)).norm() < 1e-6);
  CHECK(stage.workspace.session().undo_labels().size() == steps + 1);
  CHECK(stage.workspace.session().undo_labels().back() == "Move 2 objects");
  CHECK((stage.mover.manipulator()->pivot - Vec3(2, 2.5, 0.5)).norm() < 1e-6);
  const std::string line = recorded::to_line(*stage.mover.done());
  CHECK(line.find("\"nodes\":[\"near\",\"far\"]") != std::string::npos);
  stage.workspace.session().undo();
  CHECK(content_hash(stage.workspace.session().document()) == before);
}

TEST_CASE("object mover: one object scales along its own axes about its middle, several keep their shapes") {
  Stage stage;
  place_objects(stage.workspace, {{stage.near, {{0, 0, 0}, {0, 0, 30}, {1, 1, 1}}}});
  stage.pick({stage.near});
  stage.mover.set_kind(ManipulatorKind::Scale);
  const Vec3 middle = stage.placement(stage.near).map()({0.5, 0.5, 0.5});
  const Vec3 along = stage.mover.manipulator()->axes.col(0);
  const Vec3 grip = stage.grip(0);
  CHECK(stage.drag(grip, grip + (grip - stage.mover.manipulator()->pivot).dot(along) * along) == Verdict::Commit);
  const Placement scaled = stage.placement(stage.near);
  CHECK(scaled.scale.x() == Approx(1.7).epsilon(1e-3));  // by seven tenths of the handle's length
  CHECK(scaled.scale.y() == Approx(1).epsilon(1e-9));
  CHECK(scaled.rotation == Vec3(0, 0, 30));
  CHECK((scaled.map()({0.5, 0.5, 0.5}) - middle).norm() < 1e-6);

  stage.pick({stage.near, stage.far});
  stage.mover.set_kind(ManipulatorKind::Rotate);
  const Vec3 pivot = stage.mover.manipulator()->pivot;
  const double radius = 80 * stage.camera.frame().units_per_pixel(pivot);
  const auto on_ring = [&](double angle) { return Vec3(pivot + radius * Vec3(std::cos(angle), std::sin(angle), 0)); };
  stage.send(Kind::Begin, stage.camera.pixel_of(on_ring(0.7)), {.ctrl = true});
  REQUIRE(stage.mover.active());
  for (int i = 1; i <= 20; ++i) stage.send(Kind::Sample, stage.camera.pixel_of(on_ring(0.7 + 0.025 * i)));
  CHECK(stage.send(Kind::End, stage.camera.pixel_of(on_ring(1.2))) == Verdict::Commit);
  CHECK(stage.placement(stage.far).rotation.z() == Approx(30).margin(1e-6));  // in steps of 15
  CHECK(stage.placement(stage.near).rotation.z() == Approx(60).margin(1e-6));
  CHECK(stage.placement(stage.near).scale == scaled.scale);
}

TEST_CASE(
    "object mover: hidden and unpicked objects stay, Escape gives up, and a press beside the handles isn't taken") {
  Stage stage;
  stage.mover.set_kind(ManipulatorKind::Move);
  stage.workspace.session().select({});
  CHECK_FALSE(stage.mover.manipulator());
  stage.pick({stage.near, stage.far});
  show_objects(stage.workspace, {stage.far}, false);
  CHECK((stage.mover.manipulator()->pivot - Vec3(0.5, 0.5, 0.5)).norm() < 1e-12);
  stage.send(Kind::Begin, {5, 5});
  CHECK_FALSE(stage.mover.active());
  const ContentHash before = content_hash(stage.workspace.session().document());
  const auto steps = stage.workspace.session().undo_labels();
  const Vec2 from = stage.camera.pixel_of(stage.grip(0));
  stage.send(Kind::Begin, from);
  stage.send(Kind::Sample, from + Vec2(60, 0));
  CHECK(content_hash(stage.workspace.session().document()) != before);
  CHECK(stage.placement(stage.far) == Placement());
  CHECK(stage.send(Kind::Cancel, from) == Verdict::Revert);
  CHECK(content_hash(stage.workspace.session().document()) == before);
  CHECK(stage.workspace.session().undo_labels() == steps);
}

}  // namespace croquis
