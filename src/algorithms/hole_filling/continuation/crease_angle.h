// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// The cosine of the angle between triangles from which on an edge around the site is a crease: four times the angle
/// that four of five edges there don't exceed, so that bevels of fine models are creases and the noise of rough ones is
/// none; 12 degrees at least and 35 at most. Linear in the rims, the first
/// time for a site with a memory.
double crease_cosine(const HoleSite& site);

/// Whether an edge between triangles of these normals, of any length, is no crease.
bool is_smooth(const Vec3& normal, const Vec3& other, double crease_cosine);

}  // namespace croquis::hole_filling
