// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// Whether an edge of the site's rims goes through a triangle of the surface: every patch has a triangle at that edge,
/// so none can be sound. False where rounding leaves it open. Near-linear in the rims and what lies near them.
bool rims_cross_surface(const HoleSite& site);

}  // namespace croquis::hole_filling
