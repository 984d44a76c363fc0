// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/geometry/component_kind.h"

namespace croquis {

/// One thing that is selected: a node, or a part of it.
struct SelectedItem {
  NodeId node = 0;
  std::string part;  ///< of a drawing: a stroke's id; empty for the whole node

  friend auto operator<=>(const SelectedItem&, const SelectedItem&) = default;
};

/// Sorted by node and part, each once.
using Selection = std::vector<SelectedItem>;

/// Sorted, each item once, and without what isn't in the document: nodes that aren't there, and parts of drawings that
/// aren't strokes of theirs. Parts of other nodes are kept: only their evaluation knows them.
/// O(#selection log #selection + #nodes + #strokes of the drawings with selected parts)
Selection existing(Selection selection, const Document& document);

/// Selected parts of ONE mesh: of the mesh that a node holds or gives.
struct ComponentSelection {
  NodeId node = 0;  ///< 0 when nothing is selected
  ComponentKind kind = ComponentKind::Vertex;
  std::vector<Index> elements;  ///< sorted, each once; of edges, MeshTopology's numbers

  bool empty() const { return elements.empty(); }
  friend bool operator==(const ComponentSelection&, const ComponentSelection&) = default;
};

/// A component selection with what it needs to notice that the mesh became another one. Shared, never changed: a
/// million elements cost nothing to keep.
struct KeptComponents {
  std::shared_ptr<const ComponentSelection> selection;  ///< never null
  std::size_t faces = 0, corners = 0;                   ///< of the mesh selected in
};

/// Finds the mesh that an operation's node gives, without computing: null while it isn't there.
using MeshFinder = std::function<std::shared_ptr<const PolyMesh>(const Document&, NodeId)>;

/// Sorted, each element once, without what the mesh doesn't have. Edges are only known by their number, so they fall
/// out together when the number of faces or corners isn't the one they were selected in; elements of a computed mesh
/// do so whatever their kind. While a computed mesh isn't there, all stay.
/// @param is_new just selected, in the mesh as it is now
/// @param find   of computed meshes; empty: elements of these fall out
/// @return the same pointer when all still fits
/// O(#nodes), and O(#elements log #elements) for a new one
KeptComponents existing_components(KeptComponents components, const Document& document, bool is_new,
                                   const MeshFinder& find = {});

/// The mesh that a node is a source of, or null.
std::shared_ptr<const PolyMesh> source_mesh(const Document& document, NodeId node);

}  // namespace croquis
