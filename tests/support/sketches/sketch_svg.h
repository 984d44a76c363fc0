// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/drawing.h"

namespace croquis::test {

enum class SvgCurves {
  Polyline,  ///< every sample, exactly
  Cubic      ///< few smooth cubic Béziers within `tolerance`
};

struct SvgStyle {
  SvgCurves curves = SvgCurves::Polyline;
  double tolerance = 0.05;  ///< sketch units, of the cubics
  int decimals = -1;        ///< digits after the point; -1: as many as needed to read back exactly
  double width = 900;       ///< of the page
  double height = 700;
  bool shift = false;  ///< move y so that y up 0..height fills the page (else y is only negated)
};

/// One path per stroke, y down, strokes' ids and data attributes kept.
std::string to_svg(const Drawing& drawing, const SvgStyle& style = {});

}  // namespace croquis::test
