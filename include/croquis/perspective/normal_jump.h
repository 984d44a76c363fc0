// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/brep.h"

namespace croquis {

/// The largest angle in radians between the normals of the two faces along smooth edges, and of the patches of a face
/// along their common lines: what is left of a kink. Normals are one-sided limits at 33 places of each edge, so that no
/// distance is chosen. 0 without smooth edges and patches. Linear.
double greatest_normal_jump(const Brep& brep);

}  // namespace croquis
