// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

[[noreturn]] void refuse(const char* parameter, const char* sentence) {
  throw Error(make_error(Category::Usage, "E_PARAMETER", sentence, {{SubjectKind::Parameter, parameter, {}, {}, {}}}));
}

std::size_t segment_count(std::span<const Vec2> points, bool closed) {
  if (points.size() < 2) return 0;
  return closed ? points.size() : points.size() - 1;
}

const Vec2& segment_end(std::span<const Vec2> points, std::size_t segment) {
  return points[segment + 1 == points.size() ? 0 : segment + 1];
}

/// Which points may move.
std::vector<bool> movable_points(std::span<const Vec2> points, bool closed, const TaubinOptions& options) {
  const std::size_t count = points.size();
  std::vector<bool> movable(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_end = !closed && (i == 0 || i + 1 == count);
    movable[i] = !is_end && (options.fixed.empty() || !options.fixed[i]);
  }
  return movable;
}

void smooth_once(std::vector<Vec2>& points, const std::vector<bool>& movable, double weight) {
  const std::vector<Vec2> old = points;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!movable[i]) continue;
    const Vec2 middle = (old[(i + count - 1) % count] + old[(i + 1) % count]) / 2;
    points[i] += weight * (middle - old[i]);
  }
}

}  // namespace

std::vector<double> arc_lengths(std::span<const Vec2> points, bool closed) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 0; i < segment_count(points, closed); ++i) {
    lengths.push_back(lengths.back() + (segment_end(points, i) - points[i]).norm());
  }
  return lengths;
}

double length(std::span<const Vec2> points, bool closed) { return arc_lengths(points, closed).back(); }

std::vector<Vec2> taubin_smooth(std::span<const Vec2> points, bool closed, const TaubinOptions& options) {
  if (!options.fixed.empty() && options.fixed.size() != points.size()) {
    refuse("fixed", "The mask of fixed points must have one entry for every point of the line.");
  }
  std::vector<Vec2> smooth(points.begin(), points.end());
  const std::vector<bool> movable = movable_points(points, closed, options);
  for (int pass = 0; pass < options.passes; ++pass) {
    smooth_once(smooth, movable, options.lambda);
    smooth_once(smooth, movable, options.mu);
  }
  return smooth;
}

double nearest_parameter(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double size = along.squaredNorm();
  return size > 0 ? std::clamp((point - a).dot(along) / size, 0.0, 1.0) : 0.0;
}

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  // Seen from the first point, so that a place far from the origin costs no digits.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return twice / 2;
}

}  // namespace croquis
