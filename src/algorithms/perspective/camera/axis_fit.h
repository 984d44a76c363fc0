// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "algorithms/perspective/camera/axis_lines.h"

namespace croquis {

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
