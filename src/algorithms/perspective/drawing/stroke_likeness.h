// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/perspective_drawing.h"

namespace croquis {

/// What a stroke looks like, whichever way it was drawn: its control points in the direction whose points come first.
/// Equal for equal strokes only.
struct StrokeLook {
  std::vector<double> points;
  StrokeGroup group = StrokeGroup::Unknown;
  StrokeRole role = StrokeRole::Edge;
  double weight = 1;

  auto operator<=>(const StrokeLook&) const = default;
};

StrokeLook look_of(const PerspectiveStroke& stroke);

/// Largest distance between two strokes that join the same places, as point sets; the second one's ends are moved onto
/// the first one's. Px. @param turned the second one runs the other way
double distance_between(const PerspectiveStroke& a, const PerspectiveStroke& b, bool turned);

}  // namespace croquis
