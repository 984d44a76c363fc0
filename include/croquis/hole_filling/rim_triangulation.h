// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

/// Triangulations of rims without new vertices.
namespace croquis::hole_filling {

/// One or more closed polygons that a patch joins. The first one's inside is filled; further ones are holes in it, all
/// running so that the patch lies on their left.
struct RimPolygon {
  std::vector<Vec3> points;                   ///< #P by 3, of all loops behind one another
  std::vector<Index> loop_ends;               ///< #L, one past each loop's last point
  std::vector<std::array<Index, 2>> blocked;  ///< sorted pairs (low, high) of points that are joined already elsewhere
  std::vector<std::array<Index, 3>> avoided;  ///< sorted, each ascending: no triangles of a short rim's triangulation

  std::size_t loop_count() const { return loop_ends.size(); }
  bool is_blocked(Index a, Index b) const;

  /// The next point around its loop.
  Index next(Index point) const;
};

struct RimTriangulation {
  std::vector<std::array<Index, 3>> triangles;  ///< #T by 3, points of the polygon, turned so that rims run as given
  double area = 0;
  bool is_minimal = false;  ///< no triangulation has less area; else no flip of an edge makes it less
};

/// The triangulation of least area, or for long rims and several loops one that is near to it.
///
/// Short: dynamic programming over the polygon (Barequet and Sharir 1995, section 3), several loops being joined into
/// one by their shortest bridges. Long: constrained Delaunay in the plane nearest to the rims when they don't cross
/// there, else ears are cut off by their shortest diagonals; then edges are flipped while area goes down: n log n. A
/// trace of the squared edges is added to areas, so that flat rims, all of whose triangulations are equal, get
/// well-shaped triangles. Triangles without area and edges in `blocked` are avoided; none may be left, or nothing is
/// returned.
/// @param exact_points up to so many points the minimum is found; time n^3 (0.04 s for 300), memory n^2
/// @throws Cancelled
std::optional<RimTriangulation> triangulate_rim(const RimPolygon& polygon, Progress& progress,
                                                std::size_t exact_points = 300);

}  // namespace croquis::hole_filling
