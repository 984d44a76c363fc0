// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/component_kind.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"

/// Ways to select parts of a mesh. Elements are indices of MeshTopology: vertices, edges or faces. Lists that go in
/// may have any order; those that come out are sorted, each element once, unless said otherwise. Indices that aren't
/// the mesh's are left out. All are linear in the mesh or better.
namespace croquis {

using Elements = std::vector<Index>;

/// Number of vertices, edges or faces.
std::size_t element_count(const MeshTopology& topology, ComponentKind kind);

// ---- Lists

Elements sorted_unique(Elements elements);
Elements united(std::span<const Index> sorted_a, std::span<const Index> sorted_b);
Elements subtracted(std::span<const Index> sorted_from, std::span<const Index> sorted_what);
Elements toggled(std::span<const Index> sorted_a, std::span<const Index> sorted_b);  ///< in one of them, not in both
Elements all_elements(std::size_t count);
Elements inverted(std::span<const Index> sorted, std::size_t count);

// ---- Lines of edges

/// Edges in a row from an edge both ways: straight on through inner vertices of four edges, around a face of more than
/// four sides through vertices of three (the cap of a cylinder), along the rim through rim vertices that join two rim
/// edges; ends elsewhere.
/// @param ordered false: sorted; true: in the order of the row (the last one meets the first when it closes)
Elements edge_loop(const MeshTopology& topology, Index edge, bool ordered = false);

/// Edges opposite to each other across quads, both ways; ends at other faces, at rims and at edges of more faces.
Elements edge_ring(const MeshTopology& topology, Index edge, bool ordered = false);

/// The shortest path over edges, by length, ends included; empty when there is none.
/// @param positions #V. O(n log n) in what lies nearer than the end
Elements shortest_path(const MeshTopology& topology, std::span<const Vec3> positions, Index from, Index to);

/// The shortest path from one edge to another, both included; empty when there is none.
Elements shortest_edge_path(const MeshTopology& topology, std::span<const Vec3> positions, Index from, Index to);

/// The part of a loop or ring (ordered) from one of its elements to another, the shorter part when it closes; empty
/// when one isn't in it.
Elements part_between(std::span<const Index> ordered, Index from, Index to, bool closed);

/// Whether an ordered edge loop comes back to its beginning.
bool closes(const MeshTopology& topology, std::span<const Index> ordered_loop);

/// Whether an ordered edge ring does.
bool ring_closes(const MeshTopology& topology, std::span<const Index> ordered_ring);

// ---- Areas

Elements grown(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements);
Elements shrunk(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements);

/// All elements of the connected pieces that the given ones are in.
Elements connected(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements);

enum class ConvertRule {
  Touching,  ///< edges and faces that have one of the vertices, faces that have one of the edges
  Contained  ///< that have all their vertices (edges) among the given ones
};

/// The same place as another kind of elements. Towards vertices, and from faces to edges, the rules don't differ.
Elements converted(const MeshTopology& topology, ComponentKind from, ComponentKind to, std::span<const Index> elements,
                   ConvertRule rule = ConvertRule::Touching);

/// Edges of one face only.
Elements boundary_edges(const MeshTopology& topology);

// ---- By shape and tags

/// Edges between whose faces the angle of the normals is greater than that, 0 (flat) … 180 degrees. Edges of one face
/// or of more than two, and those of faces without an area, have none; faces that run the edge the same way are
/// compared as if one was turned over. O(#C).
Elements edges_sharper_than(const MeshTopology& topology, const PolyMesh& mesh, double degrees);

/// The whole chain of tagged edges that a tagged edge belongs to: it goes on through vertices with exactly two tagged
/// edges that aren't pinned. The edge alone when it has no tag.
Elements tagged_chain(const MeshTopology& topology, const MeshTags& tags, Index edge);

}  // namespace croquis
