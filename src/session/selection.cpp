// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/session/selection.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

namespace croquis {
namespace {

/// Looks up many items with one pass over each drawing.
class Existence {
 public:
  explicit Existence(const Document& document) {
    for (const auto& node : document.nodes()) nodes_.emplace(node->id, node.get());
  }

  bool operator()(const SelectedItem& item) {
    const auto node = nodes_.find(item.node);
    if (node == nodes_.end()) return false;
    const auto sketch = source_of<Drawing>(node->second);
    const auto sheet = source_of<PerspectiveDrawing>(node->second);
    if (item.part.empty() || (!sketch && !sheet)) return true;
    const auto [ids, added] = strokes_.try_emplace(item.node);
    const auto take_ids = [&ids = ids->second](const auto& strokes) {
      for (const auto& stroke : strokes) ids.insert(stroke.id);
    };
    if (added && sketch) take_ids(sketch->strokes);
    if (added && sheet) take_ids(sheet->strokes);
    return ids->second.contains(item.part);
  }

 private:
  std::map<NodeId, const Node*> nodes_;
  std::map<NodeId, std::set<std::string_view>> strokes_;
};

}  // namespace

std::shared_ptr<const PolyMesh> source_mesh(const Document& document, NodeId id) {
  return source_of<PolyMesh>(document.find(id));
}

namespace {

/// Sorts what comes in any order; lists that are in order already take one pass.
void put_in_order(std::vector<Index>& elements) {
  const auto not_ascending = [](Index a, Index b) { return a >= b; };
  if (std::adjacent_find(elements.begin(), elements.end(), not_ascending) == elements.end()) return;
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

/// How many of that type there can be. Of edges only a bound is known without the neighbourhoods.
std::size_t bound_of(const PolyMesh& mesh, ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return mesh.vertex_count();
  return kind == ComponentKind::Face ? mesh.face_count() : mesh.corners.size();
}

std::shared_ptr<const ComponentSelection> in_order(ComponentSelection selection) {
  put_in_order(selection.elements);
  return std::make_shared<const ComponentSelection>(std::move(selection));
}

KeptComponents kept(ComponentSelection selection, std::size_t faces, std::size_t corners) {
  if (selection.elements.empty()) selection = {};
  return {std::make_shared<const ComponentSelection>(std::move(selection)), faces, corners};
}

}  // namespace

KeptComponents existing_components(KeptComponents components, const Document& document, bool is_new,
                                   const MeshFinder& find) {
  const ComponentSelection& selection = *components.selection;
  if (selection.elements.empty()) return selection == ComponentSelection{} ? components : kept({}, 0, 0);
  const Node* node = document.find(selection.node);
  const bool computed = node != nullptr && !node->source && find;
  const auto mesh = computed ? find(document, node->id) : source_mesh(document, selection.node);
  if (!mesh && computed) return is_new ? KeptComponents{in_order(selection), 0, 0} : components;
  if (!mesh) return kept({}, 0, 0);
  const std::size_t faces = mesh->face_count();
  const std::size_t corners = mesh->corners.size();
  const std::size_t bound = bound_of(*mesh, selection.kind);
  if (is_new) {
    ComponentSelection ordered = selection;
    put_in_order(ordered.elements);
    const auto end = std::lower_bound(ordered.elements.begin(), ordered.elements.end(), bound);
    ordered.elements.erase(end, ordered.elements.end());
    return kept(std::move(ordered), faces, corners);
  }
  const bool same_connectivity = faces == components.faces && corners == components.corners;
  if (computed && !same_connectivity && components.corners > 0) return kept({}, 0, 0);
  if (selection.kind == ComponentKind::Edge && !same_connectivity) return kept({}, 0, 0);
  if (selection.elements.back() < bound) return {components.selection, faces, corners};
  ComponentSelection clipped{selection.node, selection.kind, {}};
  const auto end = std::lower_bound(selection.elements.begin(), selection.elements.end(), bound);
  clipped.elements.assign(selection.elements.begin(), end);
  return kept(std::move(clipped), faces, corners);
}

Selection existing(Selection selection, const Document& document) {
  if (selection.empty()) return selection;
  std::sort(selection.begin(), selection.end());
  selection.erase(std::unique(selection.begin(), selection.end()), selection.end());
  Existence exists(document);
  std::erase_if(selection, [&](const SelectedItem& item) { return !exists(item); });
  return selection;
}

}  // namespace croquis
