// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/painters/drawing.h"

namespace croquis::render {

/// The length on screen from each line's start to each of its corners, in pixels, as far as the line lies before the
/// eye: what keeps dashes going around corners. O(corners).
std::vector<float> lengths_on_screen(const Shown<LineItem>& shown, const OverlayFrame& frame);

}  // namespace croquis::render
