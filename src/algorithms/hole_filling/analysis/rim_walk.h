// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {

/// A rim as a cycle of the view's corners; no vertex comes twice.
struct RimCycle {
  std::vector<Index> corners;   ///< #R, in walking order
  std::vector<Index> vertices;  ///< #R, of the view, where each edge begins in walking order
  bool ambiguous = false;       ///< some edges are walked against their triangles
};

struct RimCycles {
  std::vector<RimCycle> cycles;
  std::size_t open_rims = 0;  ///< chains that don't close
};

/// Walks all rims. Where one fan of triangles ends at a vertex, the walk turns around it within the fan. Where several
/// fans meet in a vertex and lie around it like petals, it goes on with the fan across the gap, so that gaps between
/// them are holes of their own; else it stays in its fan too. Every walk is cut wherever a vertex comes again.
/// n log n in the rim edges, linear in their fans.
/// @param positions #V, of the mesh
RimCycles walk_rims(const SurfaceView& view, std::span<const Vec3> positions, Progress& progress);

}  // namespace croquis::hole_filling
