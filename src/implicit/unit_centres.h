// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/implicit/local_fit.h"

namespace croquis::implicit {

/// The points of a fit in their own unit box: shifted to its middle, divided by its longest side, without duplicates.
struct UnitCentres {
  Vec3 middle = Vec3::Zero();
  double size = 1;               ///< longest side, model units; 1 where all points are at one place
  std::vector<Vec3> positions;   ///< #C, within [-1/2, 1/2]
  std::vector<double> values;    ///< #C, of f / size
  std::vector<Vec3> gradients;   ///< #C, of f for model units; 0 where unknown
  std::vector<double> softness;  ///< #C, factor of the smoothing
  std::size_t merged = 0;
  double spacing = 0;  ///< u: mean distance of nearest neighbours, or the one asked for, / size

  bool has_gradient(std::size_t centre) const { return gradients[centre] != Vec3::Zero(); }
};

/// @throws Error (E_NO_POINTS, E_NOT_FINITE, E_COUNT), see LocalFit
UnitCentres unit_centres(const Constraints& constraints, const FitOptions& options);

}  // namespace croquis::implicit
