// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/remeshing/solids/signed_surface.h"

namespace croquis::remeshing {

/// Share of a surface's area that what is made of it may lack; more is another surface.
inline constexpr double most_lost = 0.1;

/// How a mesh compares with the surfaces that it was made of as one solid.
struct UnionFaults {
  bool has_strays = true;           ///< a vertex lies farther than two cells from all of them
  std::vector<std::size_t> losers;  ///< members of which more than a tenth has no vertex within 1.25 cells

  bool none() const { return !has_strays && losers.empty(); }
};

/// What lies in another member isn't lost. A surface with borders encloses what it goes more than half around (its
/// winding number: Jacobson, Kavan, Sorkine-Hornung 2013). Where all are closed their inside is no guess, and nothing
/// is asked.
/// @throws Cancelled
UnionFaults faults_of(const PolyMesh& made, std::span<const std::unique_ptr<const SignedSurface>> members, double cell,
                      int threads, Progress& progress);

/// How often a surface goes round a place, 1 within a closed one; linear.
double winding_number(const PolyMesh& surface, const Vec3& place);

}  // namespace croquis::remeshing
