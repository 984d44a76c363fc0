// SPDX-License-Identifier: GPL-3.0-or-later
// Whole objects: where they stand, several of them at once, groups, what is seen.
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_commands.h"
#include "croquis/workspace/step_commands.h"
#include "support/main_loop.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

Registry doubling() {
  Registry registry;
  add_operation(registry, mesh_to_mesh("double"), [](const Values& inputs, const ParameterValues&, Context&) {
    return OperationResult{
        {{"mesh", std::make_shared<const PolyMesh>(test::scaled(inputs.at("mesh").get<PolyMesh>(), 2))}}, {}};
  });
  return registry;
}

struct Table {
  MainLoop loop;
  int results = 0;
  Workspace workspace{
      doubling(),
      loop.post(),
      {.loaded = {}, .changed = {}, .result_changed = [this] { ++results; }, .progress = {}, .busy_changed = {}}};

  /// A cube from 0 to 1, moved by x.
  NodeId add(const std::string& name, double x) {
    return add_source(workspace, name, std::make_shared<const PolyMesh>(test::translated(test::cube(), {x, 0, 0})));
  }
  void settle() {
    loop.run_until([&] { return !workspace.busy(); });
  }
  std::array<Vec3, 2> box(NodeId node) {
    settle();
    return *placed_bounds(workspace, *workspace.object(node));
  }
  const WorkObject& object(NodeId node) { return *workspace.object(node); }
};

const Placement aside{{5, 0, 0}, {0, 0, 90}, {1, 2, 1}};

}  // namespace

TEST_CASE("objects: steps that come, go and freeze work on what they did, and the object stands where it stood") {
  Table table;
  const NodeId cube = table.add("cube", 0);
  place_objects(table.workspace, {{cube, aside}});
  CHECK(table.box(cube)[0] == Vec3(3, 0, 0));
  CHECK(table.box(cube)[1] == Vec3(5, 1, 1));
  const NodeId step = add_step(table.workspace, cube, "double");
  CHECK(table.box(step)[1] == Vec3(5, 2, 2));
  CHECK(table.object(step).mesh->positions.back() == 2 * test::cube().positions.back());  // in its own space
  CHECK(table.object(step).placement == aside);
  const NodeId second = add_step(table.workspace, step, "double");
  CHECK(table.box(second)[1] == Vec3(5, 4, 4));
  freeze_step(table.workspace, step);
  CHECK(table.workspace.session().document().find(cube) == nullptr);
  CHECK(table.object(second).placement == aside);
  CHECK(table.box(second)[1] == Vec3(5, 4, 4));
  remove_step(table.workspace, second);
  CHECK(table.box(step)[1] == Vec3(5, 2, 2));
  while (table.workspace.session().can_undo()) table.workspace.session().undo();
  CHECK(table.box(cube)[0] == Vec3(0, 0, 0));
}

TEST_CASE("objects: moving one computes nothing again, and impossible places are refused") {
  Table table;
  const NodeId step = add_step(table.workspace, table.add("cube", 0), "double");
  table.settle();
  const auto before = table.object(step).mesh;
  const int results = table.results;
  place_objects(table.workspace, {{step, aside}});
  CHECK_FALSE(table.workspace.busy());
  CHECK(table.object(step).mesh == before);
  CHECK(table.results == results);
  CHECK(table.workspace.session().undo_labels().back() == "Place cube");
  CHECK_THROWS_AS(place_objects(table.workspace, {{step, {{0, 0, 0}, {0, 0, 0}, {1, 0, 1}}}}), Error);
  CHECK(table.object(step).placement == aside);
}

TEST_CASE("objects: what was still being computed when others were isolated goes on when all are seen again") {
  Table table;
  const NodeId other = table.add("other", 5);
  const NodeId step = add_step(table.workspace, table.add("cube", 0), "double");
  table.workspace.isolate({other});  // before its result has come
  table.settle();
  table.workspace.isolate({});
  table.settle();
  REQUIRE(table.object(step).mesh);
  CHECK(table.object(step).mesh->positions.back() == 2 * test::cube().positions.back());
}

TEST_CASE("objects: copies step aside by as much as all of them reach, as one step, and live on their own") {
  Table table;
  const NodeId first = table.add("left", 0);
  const NodeId second = add_step(table.workspace, table.add("right", 3), "double");  // from 6 to 8
  table.settle();
  const auto steps = table.workspace.session().undo_labels().size();
  copy_objects(table.workspace, {first, second});
  CHECK(table.workspace.session().undo_labels().size() == steps + 1);
  const std::vector<NodeId> copies = picked(table.workspace);
  REQUIRE(copies.size() == 2);
  CHECK(table.box(copies[0])[0].x() == Approx(8.8));
  CHECK(table.box(copies[1])[1].x() == Approx(8 + 8.8));
  CHECK(table.box(first)[0].x() == 0);
  CHECK(table.object(copies[0]).name == "left 2");
  remove_objects(table.workspace, copies);
  CHECK(table.workspace.objects().size() == 2);
  CHECK(table.workspace.session().undo_labels().back() == "Delete 2 objects");
}

TEST_CASE("objects: a group is picked, copied and taken apart as one") {
  Table table;
  const NodeId a = table.add("a", 0), b = table.add("b", 2), c = table.add("c", 4);
  group_objects(table.workspace, {a, c});
  CHECK(table.object(a).group == "Group");
  CHECK(table.object(b).group.empty());
  CHECK(with_groups(table.workspace, {c}) == std::vector<NodeId>{a, c});
  CHECK(with_groups(table.workspace, {b}) == std::vector<NodeId>{b});
  copy_objects(table.workspace, {a, c});
  const std::vector<NodeId> copies = picked(table.workspace);
  REQUIRE(copies.size() == 2);
  CHECK(table.object(copies[0]).group == "Group 2");
  CHECK(table.object(copies[1]).group == "Group 2");
  rename_group(table.workspace, "Group 2", "Group");
  CHECK(table.object(copies[0]).group == "Group 3");
  rename_group(table.workspace, "Group 3", "Wheels");
  CHECK(with_groups(table.workspace, {copies[1]}) == copies);
  ungroup_objects(table.workspace, {a, c});
  CHECK(with_groups(table.workspace, {a}) == std::vector<NodeId>{a});
  table.workspace.session().undo();
  CHECK(with_groups(table.workspace, {a}) == std::vector<NodeId>{a, c});
}

TEST_CASE("objects: isolated ones alone are seen, without a step of the history; hiding several is one") {
  Table table;
  const NodeId a = table.add("a", 0), b = table.add("b", 2), c = table.add("c", 4);
  const auto seen = [&] {
    std::vector<NodeId> nodes;
    for (const WorkObject& object : table.workspace.objects()) {
      if (object.visible) nodes.push_back(object.node);
    }
    return nodes;
  };
  const auto steps = table.workspace.session().undo_labels();
  table.workspace.isolate({b});
  CHECK(seen() == std::vector<NodeId>{b});
  CHECK(table.workspace.session().undo_labels() == steps);
  show_objects(table.workspace, {c}, true);  // joins those that are seen
  CHECK(seen() == std::vector<NodeId>{b, c});
  CHECK(table.workspace.session().undo_labels() == steps);
  table.workspace.isolate({});
  CHECK(seen() == std::vector<NodeId>{a, b, c});
  show_objects(table.workspace, {a, c}, false);
  CHECK(seen() == std::vector<NodeId>{b});
  CHECK(table.workspace.session().undo_labels().back() == "Hide 2 objects");
  table.workspace.session().undo();
  CHECK(seen() == std::vector<NodeId>{a, b, c});
}

}  // namespace croquis::test
