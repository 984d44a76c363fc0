// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"

namespace croquis::remeshing {

/// Where components go on in one another, as views of one thing do that overlap or don't quite meet.
struct ViewSeams {
  std::vector<std::pair<Index, Index>> joined;  ///< pairs of components of the view, the lower first
  std::vector<std::uint8_t>
      vertices;  ///< per vertex of the mesh: 1 on a rim beside which a joined one goes on; or none

  /// Per hole, or none: 1 for views' rims, which more than a fifth of lies at seams. They are no holes by themselves,
  /// unless a request names them.
  std::vector<std::uint8_t> rims;

  /// Components that face the other way than those that they lie upon, ascending: see minority_of. Nothing is joined
  /// by what is still to be turned.
  std::vector<Index> turned;

  bool at(Index vertex) const { return !vertices.empty() && vertices[vertex] != 0; }
  bool are_along(Index hole) const { return !rims.empty() && rims[hole] != 0; }
};

/// A rim vertex lies at a seam when another component has a vertex within three edges, nearer than one edge along both
/// normals, which are within 53 degrees. Two components are joined by 16 such vertices, if that is a tenth of the
/// rims of one of them. n log n.
///
/// Where normals are within 53 degrees of opposite ones and more vertices say so than the contrary, one of the two is
/// turned over. Walls have two such sides, too, but they are some way apart, and their rims run along each other:
/// nothing is turned where both rims do for four fifths of their length, unless the distance is less than 0.15 edges in
/// the mean, or where that is more than half an edge.
/// @param edge as typical_edge
ViewSeams find_view_seams(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                          const std::vector<hole_filling::HoleRequest>& requests, double edge);

}  // namespace croquis::remeshing
