// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// What a pen stroke in space was meant as: lines and smooth curves.
namespace croquis {

struct StrokeCurveOptions {
  double unit = 1;                ///< model units per pixel of the view drawn in, > 0; the lengths below are px of it
  double tolerance = 2.5;         ///< greatest distance of the steadied stroke from its curve …
  double noise_share = 3.5;       ///< … or × the pen's noise, where that is more (one standard deviation)
  double smallest = 6;            ///< a stroke that goes no farther is a tap
  double straight_share = 0.025;  ///< × length: what bends less is a line
  double corner_degrees = 50;     ///< turns by more than this within `corner_reach` are corners
  double corner_reach = 14;
  std::size_t most_degree = 7;  ///< 3..12
};

/// One Bézier curve of as low a degree as will do, 1 for a line; at sharp corners and where no degree comes near one
/// for each part, each beginning where the one before ends. A stroke whose ends nearly meet is closed: then at least
/// two parts, the last ending where the first begins. Empty for a tap.
/// @param points #P by 3, as drawn: any density, repetitions allowed, finite
/// @return control polygons, both ends included
std::vector<std::vector<Vec3>> curves_of_stroke(std::span<const Vec3> points, const StrokeCurveOptions& options = {});

}  // namespace croquis
