// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/base/progress.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/uniform_schemes.h"

namespace croquis::subdivision {

/// Limits of level k's vertices.
struct LimitRows {
  int level = 0;                               ///< whose positions the rows weigh: k or k+1
  WeightRows points;                           ///< #V
  WeightRows first_tangents, second_tangents;  ///< #N normals, each their cross product
  std::vector<Index> corner_normal;            ///< #C into the normals; no_index: that of the corner's face
  std::vector<std::uint8_t> exact;             ///< #V
};

LimitRows doo_sabin_limit(const DooSabinPlan& plan, int k, Progress& progress);
LimitRows uniform_limit(const UniformPlan& plan, int k, Progress& progress);

}  // namespace croquis::subdivision
