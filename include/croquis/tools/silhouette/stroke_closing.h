// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/drawing.h"

/// Which strokes were meant to be loops.
namespace croquis {

struct CloseOptions {
  double units_per_pixel = 1;
  double distance = 12;     ///< pixels, largest gap between the ends
  double times_longer = 4;  ///< a stroke shorter than this times its gap's limit stays open: a tick is no loop
  double share = 0.015;     ///< of the stroke's length: a larger loop may miss by more, where its ends go on into each
                            ///< other or run along each other …
  double farthest = 40;     ///< … but by no more pixels than this
};

/// Whether a drawn stroke was meant to be a loop: its ends are near each other, or its end heads for its beginning and
/// would go on into it, or runs past it, beside it and the same way.
bool ends_meet(std::span<const StrokeSample> samples, const CloseOptions& options = {});

}  // namespace croquis
