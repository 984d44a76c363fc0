// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/session/selection.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

Value drawing_of(const std::vector<std::string>& ids) {
  Drawing drawing;
  for (const std::string& id : ids) {
    drawing.strokes.emplace_back();
    drawing.strokes.back().id = id;
  }
  return std::make_shared<const Drawing>(std::move(drawing));
}

TEST_CASE("a selection is sorted, and each item is in it once") {
  const Document document =
      Document().with(test::source_node(drawing_of({"a", "b"}))).with(test::source_node(test::point(1)));
  const Selection selection = existing({{2, ""}, {1, "b"}, {1, "a"}, {2, ""}, {1, ""}}, document);
  CHECK(selection == Selection{{1, ""}, {1, "a"}, {1, "b"}, {2, ""}});
}

TEST_CASE("what isn't in the document falls out of a selection") {
  const Document document = Document()
                                .with(test::source_node(drawing_of({"a"})))
                                .with(test::operation_node("scale", {1, "value"}, 2))
                                .with(test::source_node(std::shared_ptr<const Drawing>()));
  const Selection selection = existing({{1, "a"}, {1, "b"}, {2, "face 7"}, {3, "a"}, {4, ""}, {0, ""}}, document);
  CHECK(selection == Selection{{1, "a"}, {2, "face 7"}, {3, "a"}});
  CHECK(existing({{1, "a"}}, Document()).empty());
}

// ---- Components

Value mesh_of(PolyMesh mesh) { return std::make_shared<const PolyMesh>(std::move(mesh)); }

KeptComponents chosen(ComponentSelection selection) {
  return {std::make_shared<const ComponentSelection>(std::move(selection)), 0, 0};
}

TEST_CASE("components are sorted, each once, and only those that the mesh has") {
  const Document document = Document().with(test::source_node(mesh_of(test::cube())));
  const auto kept = existing_components(chosen({1, ComponentKind::Vertex, {9, 3, 3, 0, 7, 8}}), document, true);
  CHECK(*kept.selection == ComponentSelection{1, ComponentKind::Vertex, {0, 3, 7}});
  const auto faces = existing_components(chosen({1, ComponentKind::Face, {6, 5}}), document, true);
  CHECK(*faces.selection == ComponentSelection{1, ComponentKind::Face, {5}});
  CHECK(*existing_components(chosen({2, ComponentKind::Vertex, {0}}), document, true).selection ==
        ComponentSelection{});
  const Document other = Document().with(test::source_node(drawing_of({"a"})));
  CHECK(*existing_components(chosen({1, ComponentKind::Vertex, {0}}), other, true).selection == ComponentSelection{});
}

TEST_CASE("components that still fit are kept without a copy; others are clipped, edges dropped") {
  const Document cube = Document().with(test::source_node(mesh_of(test::cube())));
  Node smaller = *cube.find(1);
  smaller.source = mesh_of(test::tetrahedron());
  const Document less = cube.with(smaller);
  Node moved = *cube.find(1);
  moved.source = mesh_of(test::translated(test::cube(), {1, 0, 0}));
  const Document elsewhere = cube.with(moved);
  for (const ComponentKind kind : {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face}) {
    const auto kept = existing_components(chosen({1, kind, {0, 2, 5}}), cube, true);
    const auto same = existing_components(kept, elsewhere, false);
    CHECK(same.selection == kept.selection);
    const auto clipped = existing_components(kept, less, false);
    if (kind == ComponentKind::Edge) {
      CHECK(clipped.selection->empty());
    } else {
      CHECK(clipped.selection->elements == std::vector<Index>{0, 2});
    }
    CHECK(existing_components(kept, cube.without(1), false).selection->node == 0);
  }
}

TEST_CASE("components of a computed mesh wait while it isn't there, and fall out when it is joined otherwise") {
  const Document document =
      Document().with(test::source_node(test::point(1))).with(test::operation_node("scale", {1, "value"}, 2));
  const auto finder = [](std::shared_ptr<const PolyMesh> mesh) -> MeshFinder {
    return [mesh](const Document&, NodeId) { return mesh; };
  };
  const auto cube = std::make_shared<const PolyMesh>(test::cube());
  const auto torus = std::make_shared<const PolyMesh>(test::torus(5, 4));
  for (const ComponentKind kind : {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face}) {
    const ComponentSelection wanted{2, kind, {0, 2, 5}};
    const auto kept = existing_components(chosen({2, kind, {5, 0, 2, 99}}), document, true, finder(cube));
    CHECK(*kept.selection == wanted);
    const auto waiting = existing_components(kept, document, false, finder(nullptr));
    CHECK(waiting.selection == kept.selection);
    CHECK(existing_components(waiting, document, false, finder(cube)).selection == kept.selection);
    CHECK(existing_components(waiting, document, false, finder(torus)).selection->empty());
    CHECK(existing_components(kept, document.without(2), false, finder(cube)).selection->empty());
    CHECK(existing_components(kept, document, false).selection->empty());  // nobody knows computed meshes
  }
}

}  // namespace
}  // namespace croquis
