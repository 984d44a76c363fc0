// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// A piece of surface with one border loop per rim of a site.
struct MatchedSheet {
  PolyMesh sheet;                         ///< triangles, one component
  std::vector<std::vector<Index>> loops;  ///< per loop of the site's polygon: vertices, the triangles on their left
  std::vector<Index> arrives_at;          ///< holes beyond the site that the sheet ends at; then the rest isn't made
};

/// Finds out which border of a sheet belongs to which rim: each border vertex votes for the rim nearest to it.
///
/// Pieces that end at no rim are dropped, as are borders that end nowhere near one (pinholes): these are closed by
/// least area. Nothing where a rim has no border, or borders of the piece that has most would have to be guessed.
/// @param cell size of the sheet's triangles, and unit of its distance to the rims
/// @throws Cancelled
std::optional<MatchedSheet> match_loops(const HoleSite& site, PolyMesh sheet, double cell, Progress& progress);

}  // namespace croquis::hole_filling
