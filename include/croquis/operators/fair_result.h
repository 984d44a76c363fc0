// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace croquis {

/// What the operation `fair` did; its report is made of this.
struct FairResult {
  std::size_t free_points = 0;
  double weight = 0;                        ///< that was used, in units of the energy
  double energy_before = 0, energy = 0;     ///< of bending
  double greatest_move = 0, mean_move = 0;  ///< of the points, model units
};

inline std::size_t byte_size(const FairResult&) { return sizeof(FairResult); }

}  // namespace croquis
