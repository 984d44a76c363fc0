// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// Flips edges of a patch's triangles that meet something they shouldn't, wherever a flip leaves fewer such pairs; for
/// the few triangles that a faired patch runs into a rough rim with. At most 300 flips are looked at.
/// @return whether nothing meets any more
/// @throws Cancelled
bool untangle(const HoleSite& site, HolePatch& patch, Progress& progress);

}  // namespace croquis::hole_filling
