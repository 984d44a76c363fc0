// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/render/color.h"

namespace croquis::render {

/// The colour of an edge of that sharpness: from pale teal over green to dark blue for 0 … 10, and magenta for
/// infinite. Lightness falls all the way, so that people with any colour vision can order them; the orange and light
/// blue of selected and hovered things are left free.
/// @param sharpness as in Crease; NaN and less than 0 count as 0, more than 10 as infinite
Color sharpness_color(double sharpness);

/// The width of such an edge in pixels: 2 for the softest, 4 for infinite, so that colour isn't the only sign.
float sharpness_width(double sharpness);

/// One line of a legend.
struct SharpnessSample {
  double sharpness = 0;
  std::string label;
  Color color;
};

/// 0.5, 1, 2, 3, 5, 10 and infinite.
std::vector<SharpnessSample> sharpness_legend();

}  // namespace croquis::render
