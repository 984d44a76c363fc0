// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/tools/strokes/stroke_fit.h"

namespace croquis {

/// What the fit works on: the stroke's samples, thinned and faired.
struct FitPoints {
  std::vector<Vec2> smooth;          ///< at least one; neighbours differ
  std::vector<std::size_t> samples;  ///< the sample that each stands for, increasing
  std::vector<std::size_t> corners;  ///< 0-based points, increasing; never an end of an open stroke
  bool closed = false;               ///< and has at least three points
};

/// Finds corners, replaces each few dense samples by their mean, and fairs what lies between corners and
/// ends, which keep their places.
/// @throws Error (E_NO_STROKES, E_NOT_FINITE)
FitPoints fit_points(const Stroke& stroke, const FitOptions& options);

}  // namespace croquis
