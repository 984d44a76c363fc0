// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::remeshing {

/// What a vertex may do while edges collapse.
enum class VertexRole : std::uint8_t {
  Free,   ///< may go
  Kept,   ///< stays, and others may go where it is
  Fenced  ///< stays, and so do all edges at it
};

/// How far collapses may go, model units.
struct CollapseLimits {
  double off = 0;                          ///< vertices, and middles of edges, of the triangles in their place
  double longest = 0;                      ///< new edges
  std::span<const std::uint8_t> halvings;  ///< per vertex: how often `off` is halved there
};

/// What is left of a mesh whose edges were collapsed.
struct CollapsedMesh {
  std::vector<std::array<Index, 3>> triangles;  ///< of the vertices given
  std::vector<Index> face_of;                   ///< per triangle, ascending: whose place it has, of the faces given
  std::vector<Index> home;                      ///< per vertex given: the triangle that it lies on now; no_index: none
};

/// Merges triangles where the surface is nearly flat: edges collapse into one of their ends, those first that change
/// least volume (Lindstrom and Turk 1998, "Fast and memory efficient polygonal simplification", without memory of
/// earlier collapses), so that vertices that are left haven't moved. A collapse is refused that would change the
/// topology, turn a triangle by more than 45 degrees, make an angle below 15 degrees that is smaller than all around,
/// or leave a vertex, or the middle of an edge, farther from the triangles in its place than allowed.
///
/// Near n log n. Depends on nothing but its arguments.
/// @param mesh triangles, where not all vertices are Fenced without doubled edges @param roles per vertex; those on
/// borders mustn't be Free, nor those whose triangles aren't one fan, which should be Fenced
/// @throws Cancelled
CollapsedMesh collapse_edges(const PolyMesh& mesh, std::span<const VertexRole> roles, const CollapseLimits& limits,
                             Progress& progress);

}  // namespace croquis::remeshing
