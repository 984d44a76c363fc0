// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The vanishing points of the three axes, each from its own lines alone.
struct AxisFits {
  PerAxis<Vec3> vanishing_points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< homogeneous, u; zero: no lines
  PerAxis<bool> well_determined{};                                           ///< two lines or more
  PerAxis<double> cost{};                                                    ///< sum of squared residuals, u^2
  PerAxis<double> parallel_cost{};  ///< the same with the vanishing point at infinity
  double sigma = 0;                 ///< u, of all axes together; 0 without lines to spare
  int freedom = 0;                  ///< lines beyond what the vanishing points need
};

/// Finds each axis' point and leaves out lines that point elsewhere: never more than a third of them, nor so many that
/// fewer than two are left.
/// @param lines outliers are marked
AxisFits fit_axes(std::vector<AxisLine>& lines, const CameraOptions& options);

/// The same without looking for outliers.
AxisFits fit_kept_lines(const std::vector<AxisLine>& lines);

/// How many of so many lines may be left out.
int most_outliers(int count);

}  // namespace croquis
