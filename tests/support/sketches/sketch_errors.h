// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"

namespace croquis::test {

/// A drawing made to draw one finding.
struct ErrorSketch {
  std::string code;                  ///< the finding it must lead to
  std::vector<std::string> strokes;  ///< every id that finding must name; for E_TWO_SIDED the bar first, then the stems
  std::vector<std::string> allowed;  ///< other codes that may come with it
  Drawing drawing;
};

/// One for each of W_TINY, W_GAP, W_DOUBLE, E_KIND, E_CROSS, E_NO_LABELLING,
/// E_TOUCH, in this order.
std::vector<ErrorSketch> error_sketches();

/// The one for a code.
/// @throws std::out_of_range
ErrorSketch error_sketch(const std::string& code);

}  // namespace croquis::test
