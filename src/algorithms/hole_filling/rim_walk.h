// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

/// Walks all rims. A walk turns around a vertex within the triangles that edges join, so that its continuation is
/// unique, and every walk is cut wherever a vertex comes again. n log n in the rim edges, linear in their fans.
RimCycles walk_rims(const SurfaceView& view, Progress& progress);

}  // namespace croquis::hole_filling
