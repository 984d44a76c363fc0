// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/mid_surface.h"
#include "algorithms/silhouette/surface/sheet_basis.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Middles of the sheets, which follow the surface that they rest on.
struct Draping {
  std::vector<Index> objects;  ///< that were laid down, ascending
  Eigen::VectorXd z;           ///< per lifted vertex; 0 of other objects
};

/// Lays every object that rests on others down on their fronts, the lower ones first: its middle then follows what lies
/// below everywhere, not only at the highest place. Where the surface below is steep or ends, the middle goes on from
/// there as little bent as it can, and levels out. What isn't much thinner than all that it rests on is moved as a
/// whole.
///
/// Objects that are joined to others, pass over themselves, or lie over one another all round stay as they are.
/// @param data    of the sheets' last solve
/// @param sheets  thickness and z of that solve; draped objects get the thickness that their inclination demands
/// One factorisation per draped object. @throws Cancelled
Draping drape_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                     const MidSurfaceData& data, InflatedSheets& sheets, Progress& progress);

}  // namespace croquis::silhouette
