// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"

/// Which holes are filled: one rule for the algorithms and for hosts that list the holes first.
namespace croquis::hole_filling {

/// What a selection goes by.
struct HoleSize {
  HoleClass kind = HoleClass::Simple;
  double diameter = 0;  ///< model units
};

/// Whether a selection names a hole, or why it doesn't.
enum class Naming {
  Named,
  NotChosen,  ///< Selection::None names nothing
  Border,     ///< Selection::Inner leaves open what looks like the border of an open surface
  Largest,    ///< Selection::AllButLargest leaves this one open: of several of that diameter, the first
  TooWide     ///< its diameter is greater than the greatest that is filled
};

/// Per hole. Linear.
/// @param max_diameter as FillOptions has it
std::vector<Naming> named_holes(std::span<const HoleSize> holes, Selection selection, double max_diameter);

/// Which holes the options ask to fill: what fill_holes goes by.
struct HoleChoice {
  std::vector<bool> is_chosen;      ///< per hole
  std::vector<std::string> reason;  ///< why a hole isn't
  std::vector<bool> is_border;      ///< it isn't since it looks like a border, and may prove to be an island's
};

/// By `requests` where they name a hole, else by `only` where that isn't empty, else by the selection. Linear, but for
/// the list of ids.
/// @throws Error (E_PARAMETER) with one finding for every id in `only` that no hole has
HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options);

}  // namespace croquis::hole_filling
