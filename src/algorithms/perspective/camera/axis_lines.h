// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "croquis/perspective/camera_estimation.h"

namespace croquis {

/// A segment along an axis, u. Ends are ordered by their coordinates, so that the direction of drawing doesn't matter.
struct AxisLine {
  Index stroke = no_index;
  int axis = 0;
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
  bool outlier = false;

  double length() const { return (b - a).norm(); }
};

/// The usable lines, ordered by axis and place, so that sums don't depend on the order of the drawing.
std::vector<AxisLine> axis_lines(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                                 const SheetFrame& frame, double minimum_length);

/// How many of an axis' lines aren't left out.
PerAxis<int> lines_per_axis(std::span<const AxisLine> lines);

/// As vanishing_residual, with its derivative by the vanishing point.
double line_residual(const Vec3& vanishing_point, const AxisLine& line, Vec3* derivative = nullptr);

/// A scale for the noise from residuals of a fit: median for few wild ones, u.
/// @param unknowns of the fit
double robust_sigma(std::vector<double> residuals, int unknowns);

/// Root mean square over the degrees of freedom; 0 where there are none.
double rms_sigma(std::span<const double> residuals, int unknowns);

}  // namespace croquis
