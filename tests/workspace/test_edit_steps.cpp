// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of edits in chains: what is edited, and edits of a mesh that became another one.
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/document/content_hash.h"
#include "croquis/operators/all_operations.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_commands.h"
#include "croquis/workspace/step_commands.h"
#include "support/main_loop.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

/// A drawing becomes a cube, whatever is drawn.
OperationDescription drawing_to_mesh() {
  OperationDescription description = mesh_to_mesh("solid");
  description.inputs.front().name = "drawing";
  description.inputs.front().type = ValueType::Drawing;
  return description;
}

Registry with_solids() {
  Registry registry = all_operations();
  add_operation(registry, drawing_to_mesh(), [](const Values&, const ParameterValues&, Context&) -> OperationResult {
    return {{{"mesh", std::make_shared<const PolyMesh>(cube())}}, {}};
  });
  return registry;
}

Value value_of(PolyMesh mesh) { return std::make_shared<const PolyMesh>(std::move(mesh)); }

struct Desk {
  MainLoop loop;
  Workspace workspace{with_solids(), loop.post(), {}};

  void settle() {
    loop.run_until([&] { return !workspace.busy(); });
  }

  /// A step of edits after a mesh.
  NodeId add_edits(NodeId after, const std::string& lines) {
    settle();
    const auto mesh = final_mesh(workspace, workspace.session().document(), after);
    REQUIRE(mesh);
    const NodeId step = add_step(workspace, after, "edit", {{"do", lines}, {"connectivity", connectivity_name(*mesh)}});
    settle();
    return step;
  }

  void replace(NodeId source, PolyMesh mesh) {
    Node node = *workspace.session().document().find(source);
    node.source = value_of(std::move(mesh));
    workspace.session().edit("Replace", workspace.session().document().with(std::move(node)));
    settle();
  }

  ChainStep step(NodeId id) const {
    for (const ChainStep& step : steps_of(workspace, *workspace.object(id))) {
      if (step.node == id) return step;
    }
    return {};
  }

  std::string lines(NodeId step) const { return text_of(workspace.session().document().find(step)->parameters, "do"); }
};

TEST_CASE("the cage of a chain is its first mesh with the edits after it, and a chosen step has its own") {
  Desk desk;
  const NodeId box = add_source(desk.workspace, "box", value_of(cube()));
  CHECK(desk.workspace.active()->cage == box);
  CHECK(desk.workspace.active()->is_source());
  const NodeId edits = desk.add_edits(box, "inset faces=0 width=0.1");
  CHECK(desk.workspace.active()->cage == edits);
  CHECK(desk.workspace.active()->cage_mesh == desk.workspace.active()->mesh);
  CHECK(desk.workspace.active()->name == "box");
  const NodeId smooth = add_step(desk.workspace, edits, "subdivide");
  const NodeId fairer = add_step(desk.workspace, smooth, "subdivide");
  const NodeId last = desk.add_edits(fairer, "");
  const auto cage_when_selected = [&](NodeId node) {
    desk.workspace.session().select({{node, ""}});
    return desk.workspace.active()->cage;
  };
  CHECK(cage_when_selected(box) == edits);
  CHECK(cage_when_selected(edits) == edits);
  CHECK(cage_when_selected(smooth) == edits);
  CHECK(cage_when_selected(fairer) == smooth);
  CHECK(cage_when_selected(last) == last);
  CHECK(desk.workspace.active()->cage_mesh->face_count() == mesh_at(desk.workspace, fairer)->face_count());
}

TEST_CASE("the solid of a drawing has a cage while elements are picked, and for good once it was edited") {
  Desk desk;
  Drawing drawing;
  drawing.strokes.push_back({});
  const NodeId sketch = add_source(desk.workspace, "sketch", std::make_shared<const Drawing>(drawing));
  const NodeId solid = add_step(desk.workspace, sketch, "solid");
  desk.settle();
  const auto object = [&]() -> const WorkObject& { return *desk.workspace.active(); };
  CHECK(object().cage == 0);
  CHECK(object().editable == solid);
  CHECK_FALSE(object().cage_mesh);
  desk.workspace.set_edits_elements(true);
  CHECK(object().cage == solid);
  CHECK(object().cage_mesh == object().mesh);
  desk.workspace.set_edits_elements(false);
  CHECK(object().cage == 0);
  const NodeId edits = desk.add_edits(solid, "inset faces=0 width=0.1");
  CHECK(object().cage == edits);
  desk.workspace.set_view(object().node, ChainView::Cage);
  desk.settle();
  CHECK(object().shown()->face_count() == 10);
}

TEST_CASE("edits of a mesh that is joined otherwise now need attention, and show their last result") {
  Desk desk;
  const NodeId box = add_source(desk.workspace, "box", value_of(cube()));
  const NodeId edits = desk.add_edits(box, "extrude faces=3 distance=1");
  CHECK(desk.step(edits).state == StepState::Fresh);
  desk.replace(box, scaled(cube(), 3));
  CHECK(desk.step(edits).state == StepState::Fresh);
  desk.replace(box, torus(7, 5));
  CHECK(desk.step(edits).state == StepState::NeedsAttention);
  CHECK_FALSE(desk.step(edits).problem.empty());
  CHECK(desk.workspace.active()->mesh->face_count() == 10);

  reapply_step(desk.workspace, edits);
  desk.settle();
  CHECK(desk.step(edits).state == StepState::Fresh);
  CHECK(desk.workspace.active()->mesh->face_count() == 35 + 4);
  CHECK(desk.lines(edits) == "extrude faces=3 distance=1");
  desk.workspace.session().undo();
  CHECK(desk.step(edits).state == StepState::NeedsAttention);

  desk.replace(box, grid(2, 1));
  const ContentHash before = content_hash(desk.workspace.session().document());
  CHECK_THROWS_AS(reapply_step(desk.workspace, edits), Error);  // there is no face 3
  CHECK_THROWS_AS(reapply_step(desk.workspace, box), Error);
  CHECK(content_hash(desk.workspace.session().document()) == before);
}

TEST_CASE("edits applied again by position pick the same places of a mesh that was numbered otherwise and moved") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Desk desk;
    const PolyMesh first = torus(9, 7);
    const NodeId ring = add_source(desk.workspace, "ring", value_of(first));
    const NodeId edits = desk.add_edits(ring, "move vertices=5,11 by=0,0,0.02; extrude faces=20 distance=0.1");
    const PolyMesh wanted = *desk.workspace.active()->mesh;
    const Vec3 offset(0.01, -0.01, 0.005);
    desk.replace(ring, translated(shuffled(first, seed), offset));
    REQUIRE(desk.step(edits).state == StepState::NeedsAttention);
    reapply_step_by_position(desk.workspace, edits);
    desk.settle();
    CHECK(desk.step(edits).state == StepState::Fresh);
    const PolyMesh& found = *desk.workspace.active()->mesh;
    REQUIRE(found.vertex_count() == wanted.vertex_count());
    for (const Vec3& place : wanted.positions) {
      double nearest = 1e9;
      for (const Vec3& other : found.positions) nearest = std::min(nearest, (other - offset - place).norm());
      CHECK(nearest < 1e-9);
    }
    desk.workspace.session().undo();
    CHECK(desk.step(edits).state == StepState::NeedsAttention);
  }
}

TEST_CASE("steps after edits that don't fit wait, say for what, and keep their shape or follow on request") {
  Desk desk;
  const NodeId box = add_source(desk.workspace, "box", value_of(cube()));
  const NodeId edits = desk.add_edits(box, "extrude faces=3 distance=1");
  const NodeId smooth = add_step(desk.workspace, edits, "subdivide");
  desk.settle();
  const std::size_t faces = mesh_at(desk.workspace, smooth)->face_count();
  CHECK(kept_results(desk.workspace).empty());
  desk.replace(box, torus(7, 5));
  CHECK(desk.step(edits).state == StepState::NeedsAttention);
  CHECK(desk.step(smooth).state == StepState::Held);
  CHECK(desk.step(smooth).waits_for == "Edit");
  CHECK(desk.step(smooth).problem.find("'Subdivide' waits for 'Edit'") == 0);
  // One sentence, about the step that has to be mended.
  const std::vector<NodeFinding> findings = findings_of(desk.workspace);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].node == edits);
  CHECK(findings[0].finding.code == connectivity_code);

  // Saved, or recovered, and opened again, all is as it was.
  const KeptResults kept = kept_results(desk.workspace);
  REQUIRE(kept.size() == 2);
  Desk other;
  other.workspace.load(desk.workspace.session().document(), false, {kept, {}});
  other.settle();
  for (const bool keeps : {true, false}) {
    CHECK(other.step(edits).state == StepState::NeedsAttention);
    CHECK(other.step(smooth).state == StepState::Held);
    CHECK(other.workspace.active()->mesh->face_count() == faces);
    if (keeps) {
      freeze_step(other.workspace, edits);
    } else {
      reapply_step_by_position(other.workspace, edits);
    }
    other.settle();
    CHECK(other.step(smooth).state == StepState::Fresh);
    CHECK((other.workspace.active()->mesh->face_count() == faces) == keeps);
    CHECK(kept_results(other.workspace).empty());
    other.workspace.session().undo();
    other.settle();
  }
  // The end of a chain, too, becomes an object of its own.
  freeze_step(other.workspace, smooth);
  other.settle();
  CHECK(other.workspace.active()->chain == std::vector<NodeId>{smooth});
  CHECK(other.workspace.active()->mesh->face_count() > 0);
}

TEST_CASE("without the mesh that edits were made for, they aren't applied by position") {
  Desk desk;
  const NodeId box = add_source(desk.workspace, "box", value_of(cube()));
  const NodeId edits = desk.add_edits(box, "extrude faces=3 distance=1");
  Node node = *desk.workspace.session().document().find(box);
  node.source = value_of(torus(7, 5));
  const Document document = desk.workspace.session().document().with(std::move(node));
  Desk other;
  other.workspace.load(document);
  other.settle();
  try {
    reapply_step_by_position(other.workspace, edits);
    FAIL("applied");
  } catch (const Error& error) {
    CHECK(error.findings().front().code == "E_STEP");
  }
}

}  // namespace
}  // namespace croquis::test
