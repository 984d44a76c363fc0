// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/object_commands.h"
#include "croquis/workspace/step_commands.h"
#include "support/main_loop.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

Registry scaling() {
  Registry registry;
  const auto compute = [](const Values& inputs, const ParameterValues& parameters, Context&) {
    if (x_of(inputs.at("mesh")) > 1000) {
      throw Error(make_error(Category::Geometry, "E_TRIAL", "The mesh is too far away."));
    }
    return scaled(inputs, parameters);
  };
  add_operation(registry, mesh_to_mesh("scale"), compute);
  add_operation(registry, mesh_to_mesh("other"), compute);
  return registry;
}

/// A workspace with one mesh at x = 1.
struct Desk {
  MainLoop loop;
  int loads = 0, changes = 0, results = 0;
  Workspace workspace;
  NodeId mesh = 0;

  Desk()
      : workspace(scaling(), loop.post(),
                  {.loaded = [this] { ++loads; },
                   .changed = [this] { ++changes; },
                   .result_changed = [this] { ++results; },
                   .progress = {},
                   .busy_changed = {}}) {
    mesh = add_source(workspace, "bolt", point(1));
  }

  void settle() {
    loop.run_until([&] { return !workspace.busy(); });
  }

  double end(NodeId node) {
    settle();
    const WorkObject* object = workspace.object(node);
    REQUIRE(object != nullptr);
    REQUIRE(object->mesh);
    return object->mesh->positions.front().x();
  }

  void move_source(double x) {
    Node node = *workspace.session().document().find(mesh);
    node.source = point(x);
    workspace.session().edit("Move", workspace.session().document().with(std::move(node)));
  }

  StepState state(NodeId step) const {
    for (const ChainStep& s : steps_of(workspace, *workspace.object(step))) {
      if (s.node == step) return s.state;
    }
    return StepState::Source;
  }
};

TEST_CASE("workspace: a value that is given is kept, also where it equals the default") {
  Desk desk;
  const NodeId step = add_step(desk.workspace, desk.mesh, "scale", {{"factor", 5.0}});
  desk.workspace.set_parameter(step, "factor", 2.0, false);
  const Node& node = *desk.workspace.session().document().find(step);
  CHECK(node.parameters == ParameterValues{{"factor", 2.0}});
  CHECK(desk.end(step) == 2);
  const OperationDescription& operation = *desk.workspace.description("scale");
  CHECK(values_of(Node(), operation) == ParameterValues{{"factor", 2.0}});
}

TEST_CASE("workspace: the end of a chain follows its beginning") {
  Desk desk;
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale");
  const NodeId second = add_step(desk.workspace, first, "other", {{"factor", 5.0}});
  REQUIRE(desk.workspace.objects().size() == 1);
  CHECK(desk.workspace.objects().front().chain == std::vector<NodeId>{desk.mesh, first, second});
  CHECK(desk.end(second) == 10);
  desk.move_source(3);
  CHECK(desk.end(second) == 30);
  enable_step(desk.workspace, first, false);
  CHECK(desk.state(first) == StepState::Off);
  CHECK(desk.end(second) == 15);
  enable_step(desk.workspace, first, true);
  CHECK(desk.end(second) == 30);
  CHECK(mesh_at(desk.workspace, first)->positions.front().x() == 6);
}

TEST_CASE("workspace: steps say what is known of them") {
  Desk desk;
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale", {{"factor", 3.0}});
  const NodeId second = add_step(desk.workspace, first, "other");
  desk.settle();  // a busy machine may have computed it before anybody could look
  CHECK(desk.state(desk.mesh) == StepState::Source);
  CHECK(desk.state(first) == StepState::Fresh);
  CHECK(desk.state(second) == StepState::Fresh);
  desk.move_source(500);  // the first step gives 1500, which is too far for the second
  desk.settle();
  CHECK(desk.state(first) == StepState::Fresh);
  CHECK(desk.state(second) == StepState::Stale);
  CHECK(steps_of(desk.workspace, *desk.workspace.object(second)).back().problem == "The mesh is too far away.");
  CHECK(desk.end(second) == 6);  // as it was
  enable_step(desk.workspace, first, false);
  CHECK(desk.end(second) == 1000);
  CHECK(desk.state(second) == StepState::Fresh);
}

TEST_CASE("workspace: only what was computed can be frozen") {
  Desk desk;
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale");
  const NodeId second = add_step(desk.workspace, first, "other", {{"factor", 7.0}});
  desk.move_source(2000);  // too far for both
  const NodeId third = add_step(desk.workspace, second, "scale");
  desk.settle();
  CHECK_THROWS_AS(freeze_step(desk.workspace, third), Error);
  CHECK_THROWS_AS(freeze_step(desk.workspace, desk.mesh), Error);
  desk.workspace.session().undo();
  desk.workspace.session().undo();
  desk.settle();
  freeze_step(desk.workspace, first);
  CHECK(desk.workspace.objects().front().chain == std::vector<NodeId>{first, second});
  CHECK(desk.workspace.session().document().find(desk.mesh) == nullptr);
  CHECK(desk.end(second) == 14);
  desk.workspace.session().undo();
  desk.move_source(2);
  CHECK(desk.end(second) == 28);
}

TEST_CASE("workspace: undo to the start and redo to the end give the same documents") {
  Desk desk;
  std::vector<ContentHash> hashes;
  const auto note = [&] { hashes.push_back(content_hash(desk.workspace.session().document())); };
  note();
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale");
  note();
  add_step(desk.workspace, first, "other");
  note();
  move_step(desk.workspace, first, 1);
  note();
  copy_step(desk.workspace, first);
  note();
  enable_step(desk.workspace, first, false);
  note();
  copy_objects(desk.workspace, {first});
  note();
  remove_step(desk.workspace, first);
  note();
  remove_objects(desk.workspace, {desk.mesh});
  note();
  Session& session = desk.workspace.session();
  REQUIRE(session.undo_labels().size() + 1 == hashes.size());
  for (std::size_t i = hashes.size(); i-- > 1;) {
    CHECK(content_hash(session.document()) == hashes[i]);
    session.undo();
  }
  CHECK_FALSE(session.can_undo());
  for (std::size_t i = 0; i + 1 < hashes.size(); ++i) {
    CHECK(content_hash(session.document()) == hashes[i]);
    session.redo();
  }
  CHECK(content_hash(session.document()) == hashes.back());
}

TEST_CASE("workspace: the selected step is the active one, and its object stays active") {
  Desk desk;
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale");
  const NodeId second = add_step(desk.workspace, first, "other");
  const NodeId cube = add_source(desk.workspace, "cube", point(4));
  CHECK(desk.workspace.active()->node == cube);
  desk.workspace.session().select({{first, ""}});
  CHECK(desk.workspace.active()->node == second);
  CHECK(active_step(desk.workspace) == first);
  CHECK(active_operation(desk.workspace)->operation == "scale");
  desk.workspace.session().select({});
  CHECK(desk.workspace.active()->node == second);
  CHECK(active_step(desk.workspace) == second);
}

TEST_CASE("workspace: results are kept back while they are held") {
  Desk desk;
  const NodeId first = add_step(desk.workspace, desk.mesh, "scale");
  desk.settle();
  desk.workspace.hold_results(true);
  desk.move_source(9);
  const int before = desk.results;
  desk.settle();
  CHECK(desk.results == before);
  CHECK(desk.workspace.object(first)->mesh->positions.front().x() == 2);
  desk.workspace.hold_results(false);
  CHECK(desk.results == before + 1);
  CHECK(desk.workspace.object(first)->mesh->positions.front().x() == 18);
}

}  // namespace
}  // namespace croquis::test
