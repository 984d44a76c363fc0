// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {

struct Welding {
  std::vector<Index> representative;  ///< #V, or empty when no two used vertices are at one place
  std::size_t welded = 0;
  double widest_gap = 0;  ///< the greatest distance between two vertices that became one, model units
};

/// For each vertex that a face uses the lowest such vertex with exactly equal coordinates; others stay themselves.
/// Expected linear: an open-addressed table of indices, whose order never shows.
Welding weld_identical(const PolyMesh& mesh, Progress& progress);

/// The same for vertices of rims that are nearly at one place, as where two exports of one seam differ by rounding:
/// those within `tolerance` of each other and nearer than half the rim edges beside them, the nearest pairs first. Two
/// ends of an edge never become one. Vertices that were one in the view stay so; empty when no more become one.
/// Costs n log n in the rims' vertices and the pairs that are within `tolerance` along one axis.
/// @param tolerance model units, 0 for none
Welding weld_rims(const PolyMesh& mesh, const SurfaceView& view, double tolerance, Progress& progress);

}  // namespace croquis::hole_filling
