// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tracing/traced_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "croquis/geometry/bezier_fit.h"
#include "croquis/geometry/polyline.h"

namespace croquis::tracing {
namespace {

constexpr double spacing = 2;      // pixels between points that are fitted, and points of the result
constexpr double tolerance = 0.6;  // pixels, of a curve from the middle of a line
constexpr double corner_turn = 55 * std::numbers::pi / 180;
constexpr double least_reach = 5;   // pixels on both sides over which the turn of a corner is measured, or
constexpr double corner_reach = 4;  // half widths, if that is more

/// Adds points along the curves through a row that has no corner inside; the row's last point isn't added.
void add_curves(const std::vector<Vec3>& row, BezierFitOptions options, std::vector<Vec2>& result) {
  options.tolerance = tolerance;
  for (const FittedBezier& curve : fit_beziers(row, options)) {
    const std::size_t count = curve.last - curve.first;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count);
      std::vector<Vec3> p = curve.control;
      for (std::size_t left = p.size() - 1; left > 0; --left) {
        for (std::size_t j = 0; j < left; ++j) p[j] += t * (p[j + 1] - p[j]);
      }
      result.push_back(p.front().head<2>());
    }
  }
}

Vec3 in_space(const Vec2& point) { return {point.x(), point.y(), 0}; }

}  // namespace

TracedLine smooth_curve(const TracedLine& line, double half_width) {
  const double apart = std::min(spacing, length(line.points, line.closed) / 3);
  std::vector<Vec2> points = even_points(line.points, line.closed, apart);
  const double reach = std::max(least_reach, corner_reach * half_width);
  const std::vector<Index> corners = corners_of(points, line.closed, reach, corner_turn);
  TaubinOptions fairing;
  fairing.fixed.assign(points.size(), false);
  for (const Index corner : corners) fairing.fixed[corner] = true;
  points = taubin_smooth(points, line.closed, fairing);
  TracedLine result{{}, line.closed};
  const std::size_t n = points.size();
  std::vector<std::size_t> ends;
  if (!line.closed) ends.push_back(0);
  ends.insert(ends.end(), corners.begin(), corners.end());
  const bool is_smooth_ring = ends.empty();
  if (is_smooth_ring) ends.push_back(0);
  ends.push_back(line.closed ? ends.front() + n : n - 1);
  BezierFitOptions options;
  if (is_smooth_ring) {
    std::vector<Vec3> ring;
    std::ranges::transform(points, std::back_inserter(ring), in_space);
    options.start_direction = options.end_direction = row_direction(ring, 0, 3 * spacing, true);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    std::vector<Vec3> row;
    for (std::size_t k = ends[i]; k <= ends[i + 1]; ++k) row.push_back(in_space(points[k % n]));
    add_curves(row, options, result.points);
  }
  if (!line.closed) result.points.push_back(points.back());
  return result;
}

}  // namespace croquis::tracing
