// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "croquis/mesh_editing/mesh_selection.h"

/// Steps from edge to edge, of which loops, rings and cuts are made.
namespace croquis {

/// An edge with a sense: seen from `from` towards its other end.
struct DirectedEdge {
  Index edge = no_index;
  Index from = no_index;
};

/// The end of an edge that isn't the one given.
Index other_end(const MeshTopology& topology, Index edge, Index vertex);

/// Edges of a vertex, each once, in any order.
Elements edges_at(const MeshTopology& topology, Index vertex);

/// The next edge of the loop beyond the vertex, or no_index where there is none.
Index straight_on(const MeshTopology& topology, Index edge, Index vertex);

/// One step of a ring: out of an edge, across a quad, into the edge opposite, which runs the same way.
struct RingStep {
  Index face = no_index;
  DirectedEdge edge;
};

/// Across the face of a corner that starts the edge; nothing unless that is a quad with four different vertices.
std::optional<RingStep> across(const MeshTopology& topology, const DirectedEdge& edge, Index corner);

/// A whole ring: faces[i] lies between edges[i] and edges[i + 1], or, when closed, the last one between the last edge
/// and the first. No edge and no face comes twice.
struct EdgeRing {
  std::vector<DirectedEdge> edges;
  std::vector<Index> faces;
  bool closed = false;
};

EdgeRing walk_ring(const MeshTopology& topology, Index edge);

}  // namespace croquis
