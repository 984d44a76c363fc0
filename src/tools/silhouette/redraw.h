// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/geometry/drawing.h"

namespace croquis {

struct RedrawLimits {
  double distance = 10;  ///< sketch units, how near both ends of the new stroke run to the old one
  double degrees = 35;   ///< how much they may differ in direction there
};

struct Redrawn {
  std::vector<StrokeSample> samples;  ///< of the old stroke, a part of them replaced
  double distance = 0;                ///< of the new ends to the old stroke, summed
};

/// The old stroke with the part between the new stroke's ends replaced by the new one, or nothing when the new stroke
/// is no correction of it: both ends must run along the old stroke, in one sense. A line that ends on another from the
/// side (a limb that goes behind a body) doesn't. Samples that are kept keep every bit; the new ones are shifted onto
/// the old line near their ends, and their times fitted in between.
/// O(samples of the old stroke + samples of the new one).
std::optional<Redrawn> redraw(const Stroke& old, const Stroke& drawn, const RedrawLimits& limits);

}  // namespace croquis
