// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/axis_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/limits.h"

namespace croquis {
namespace {

/// An axis with fewer long lines than this takes its short ones, too, down to this part of the least length.
constexpr int fewest_lines = 3;
constexpr double shortest_part = 0.2;

/// Short lines say little of an axis that has long ones.
std::vector<AxisLine> without_short_lines(const std::vector<AxisLine>& lines, double minimum_length) {
  PerAxis<int> long_lines{};
  for (const AxisLine& line : lines) long_lines[line.axis] += line.length() >= minimum_length ? 1 : 0;
  std::vector<AxisLine> kept;
  for (const AxisLine& line : lines) {
    if (line.length() >= minimum_length || long_lines[line.axis] < fewest_lines) kept.push_back(line);
  }
  return kept;
}

bool left_before_right(const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }

}  // namespace

std::vector<AxisLine> axis_lines(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                                 const SheetFrame& frame, double minimum_length) {
  std::vector<AxisLine> lines;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const PerspectiveStroke& stroke = drawing.strokes[s];
    if (!is_parallel(groups[s]) || !are_usable_numbers(stroke.start()) || !are_usable_numbers(stroke.end())) continue;
    AxisLine line{static_cast<Index>(s), axis_of(groups[s]), frame.to_sheet(stroke.start()),
                  frame.to_sheet(stroke.end())};
    if (line.length() < shortest_part * minimum_length) continue;
    if (left_before_right(line.b, line.a)) std::swap(line.a, line.b);
    lines.push_back(line);
  }
  const auto place = [](const AxisLine& line) {
    return std::tuple(line.axis, line.a.x(), line.a.y(), line.b.x(), line.b.y());
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const AxisLine& one, const AxisLine& other) { return place(one) < place(other); });
  return without_short_lines(lines, minimum_length);
}

PerAxis<int> lines_per_axis(std::span<const AxisLine> lines) {
  PerAxis<int> counts{};
  for (const AxisLine& line : lines) counts[line.axis] += line.outlier ? 0 : 1;
  return counts;
}

double line_residual(const Vec3& vanishing_point, const AxisLine& line, Vec3* derivative) {
  // Twice the area between the vanishing point and the segment, over the distance of the vanishing point from its
  // middle; homogeneous, so that neither grows beyond bounds.
  constexpr double factor = std::numbers::sqrt2 / 2;
  const Vec2 middle = (line.a + line.b) / 2;
  const Vec2 along = line.b - line.a;
  const Vec2 towards = vanishing_point.head<2>() - vanishing_point.z() * middle;
  const double distance = towards.norm();
  if (!(distance > 0)) {
    if (derivative != nullptr) derivative->setZero();
    return 0;
  }
  const double residual = factor * cross(towards, along) / distance;
  if (derivative != nullptr) {
    const Vec2 by_towards =
        factor / distance * Vec2(along.y(), -along.x()) - residual / (distance * distance) * towards;
    *derivative << by_towards, -by_towards.dot(middle);
  }
  return residual;
}

double vanishing_residual(const Vec3& vanishing_point, const Vec2& a, const Vec2& b) {
  return std::abs(line_residual(vanishing_point, AxisLine{no_index, 0, a, b}));
}

double robust_sigma(std::vector<double> residuals, int unknowns) {
  constexpr double of_normal_distribution = 1.4826;
  const auto count = static_cast<double>(residuals.size());
  if (residuals.empty() || count <= unknowns) return 0;
  for (double& residual : residuals) residual = std::abs(residual);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return of_normal_distribution * *middle * std::sqrt(count / (count - unknowns));
}

double rms_sigma(std::span<const double> residuals, int unknowns) {
  const auto freedom = static_cast<double>(residuals.size()) - unknowns;
  if (freedom <= 0) return 0;
  double sum = 0;
  for (const double residual : residuals) sum += residual * residual;
  return std::sqrt(sum / freedom);
}

}  // namespace croquis
