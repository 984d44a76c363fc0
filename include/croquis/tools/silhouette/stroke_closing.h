// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/drawing.h"

/// Which strokes were meant to be loops.
namespace croquis {

struct CloseOptions {
  double units_per_pixel = 1;
  double distance = 12;     ///< pixels: ends nearer than this close the stroke …
  double times_longer = 4;  ///< … unless it is shorter than this times the distance: a tick is no loop
  /// Of the stroke's length: how far its end may stop short of its beginning, or run past it. A little more than the
  /// five percent that hands miss: the length is that of what was drawn.
  double share = 0.055;
  double aside_share = 0.035;  ///< of its length: how far aside it may do so
  double least_length = 16;    ///< pixels: shorter strokes stay open
};

/// Whether a drawn stroke was meant to be a loop: its ends are near each other, or its end heads for its beginning and
/// would go on into it, or runs past it, beside it and the same way, or both ends head for one corner.
bool ends_meet(std::span<const StrokeSample> samples, const CloseOptions& options = {});

}  // namespace croquis
