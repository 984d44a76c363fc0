// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/subdivision/refinement/face_mask.h"
#include "algorithms/subdivision/refinement/refine.h"

namespace croquis::subdivision {

/// The points of a level from those of the level before.
/// @param old_points #V of `old`; @param points #V of `made`
void compute_positions(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* old_points,
                       Vec3* points, int threads);

}  // namespace croquis::subdivision
