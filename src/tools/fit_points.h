// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/tools/stroke_fit.h"

namespace croquis {

/// What the fit works on: the distinct samples of a stroke.
struct FitPoints {
  std::vector<Vec2> drawn;           ///< as drawn
  std::vector<Vec2> smooth;          ///< the same, faired
  std::vector<std::size_t> samples;  ///< their numbers in the stroke, increasing
  std::vector<std::size_t> corners;  ///< 0-based, increasing; never an end of an open stroke
  bool closed = false;               ///< and has at least three points
};

/// Leaves out repeated points, finds corners, and fairs what lies between them.
/// @throws Error (E_NO_STROKES, E_NOT_FINITE)
FitPoints fit_points(const Stroke& stroke, const FitOptions& options);

}  // namespace croquis
