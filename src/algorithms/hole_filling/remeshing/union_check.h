// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "algorithms/hole_filling/remeshing/signed_surface.h"

namespace croquis::hole_filling {

/// Share of a surface's area that what is made of it may lack; more is another surface.
inline constexpr double most_lost = 0.1;

/// Whether a mesh stands for the surfaces that it was made of as one solid: no vertex farther than two cells from all
/// of them, and of what lies in none of the others no more than a tenth without a vertex within 1.25 cells. A surface
/// with borders encloses what it goes more than half around (its winding number: Jacobson, Kavan, Sorkine-Hornung
/// 2013); closed ones aren't asked about what they have lost, since their inside is no guess.
/// @throws Cancelled
bool stands_for(const PolyMesh& made, std::span<const std::unique_ptr<const SignedSurface>> members, double cell,
                int threads, Progress& progress);

/// How often a surface goes round a place, 1 within a closed one; linear.
double winding_number(const PolyMesh& surface, const Vec3& place);

}  // namespace croquis::hole_filling
