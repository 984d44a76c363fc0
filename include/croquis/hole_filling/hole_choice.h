// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"

namespace croquis::hole_filling {

/// Which holes the options ask to fill: what fill_holes goes by, for hosts that list the holes first.
struct HoleChoice {
  std::vector<bool> is_chosen;      ///< per hole
  std::vector<std::string> reason;  ///< why a hole isn't
};

/// The hole that "all but the largest" leaves open: of the largest diameter, as lists and reports give it; of several,
/// the one with the lowest id. no_index without holes. Diameters are in the holes' order.
Index largest_hole(std::span<const double> diameters);

/// Linear, but for the list of ids.
/// @throws Error (E_PARAMETER) with one finding for every id in `only` that no hole has
HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options);

}  // namespace croquis::hole_filling
