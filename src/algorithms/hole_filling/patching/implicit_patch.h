// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// Moves a patch of correct connectivity onto the surface continued, in rounds of smoothing, projection, splits,
/// collapses and flips; it meets the rims and goes through the places that the site wishes for.
/// @param most_triangles a patch that would get more is made of larger ones
/// @return nothing when the patch moves away from its rims or doesn't come to rest
/// @throws Cancelled
std::optional<HolePatch> lay_onto(const HoleSite& site, const RimField& surface, const HolePatch& start,
                                  std::size_t most_triangles, Progress& progress);

}  // namespace croquis::hole_filling
