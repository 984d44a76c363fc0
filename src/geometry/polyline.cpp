// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/predicates.h"

namespace croquis {
namespace {

/// More samples than this are a mistake in the step, not a wish.
constexpr double max_samples = 1e8;

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

/// Arc length from the first point to the start of each segment, and the whole length at the end.
std::vector<double> arc_lengths(std::span<const Vec2> points, bool closed) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 0; i < segment_count(points, closed); ++i) {
    lengths.push_back(lengths.back() + (segment_end(points, i) - points[i]).norm());
  }
  return lengths;
}

/// Parameter of the place on the segment nearest to a point.
double nearest_parameter(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double size = along.squaredNorm();
  return size > 0 ? std::clamp((point - a).dot(along) / size, 0.0, 1.0) : 0.0;
}

double turning_angle(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 in = at - before;
  const Vec2 out = after - at;
  return std::abs(std::atan2(cross(in, out), in.dot(out)));
}

/// Which points may move.
std::vector<bool> movable_points(std::span<const Vec2> points, bool closed, const TaubinOptions& options) {
  const std::size_t count = points.size();
  std::vector<bool> movable(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_end = !closed && (i == 0 || i + 1 == count);
    const bool is_fixed = !options.fixed.empty() && options.fixed[i];
    movable[i] =
        !is_end && !is_fixed &&
        turning_angle(points[(i + count - 1) % count], points[i], points[(i + 1) % count]) < options.corner_angle;
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

double length(std::span<const Vec2> points, bool closed) { return arc_lengths(points, closed).back(); }

std::vector<Vec2> resample(std::span<const Vec2> points, bool closed, double step) {
  if (!(step > 0)) refuse("step", "The distance of samples must be greater than 0.");
  if (points.empty()) return {};
  const std::vector<double> lengths = arc_lengths(points, closed);
  const double total = lengths.back();
  if (!(total > 0)) return {points.front()};
  if (!(total / step <= max_samples))
    refuse("step", "The distance of samples is too small for the length of the line.");

  const auto pieces = static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(total / step)));
  std::vector<Vec2> samples = {points.front()};
  std::size_t segment = 0;
  for (std::size_t i = 1; i < pieces; ++i) {
    const double at = total * static_cast<double>(i) / static_cast<double>(pieces);
    while (segment + 2 < lengths.size() && lengths[segment + 1] < at) ++segment;
    const double size = lengths[segment + 1] - lengths[segment];
    const double parameter = size > 0 ? std::min((at - lengths[segment]) / size, 1.0) : 0.0;
    samples.emplace_back(points[segment] + parameter * (segment_end(points, segment) - points[segment]));
  }
  if (!closed) samples.push_back(points.back());
  return samples;
}

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

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  // Seen from the first point, so that a place far from the origin costs no digits.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return twice / 2;
}

int winding_number(std::span<const Vec2> polygon, const Vec2& point) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = segment_end(polygon, i);
    // A ray to the right is crossed by segments that end on different sides of it; "on it" counts as above.
    const bool a_below = a.y() < point.y();
    const bool b_below = b.y() < point.y();
    if (a_below && !b_below && orientation(a, b, point) > 0) ++turns;
    if (!a_below && b_below && orientation(a, b, point) < 0) --turns;
  }
  return turns;
}

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  return (a + nearest_parameter(point, a, b) * (b - a) - point).norm();
}

PolylinePoint closest_point(std::span<const Vec2> points, bool closed, const Vec2& point) {
  PolylinePoint nearest;
  if (points.size() == 1) return {0, 0, points[0], (points[0] - point).norm()};
  for (std::size_t i = 0; i < segment_count(points, closed); ++i) {
    const Vec2& a = points[i];
    const Vec2& b = segment_end(points, i);
    const double parameter = nearest_parameter(point, a, b);
    const Vec2 position = a + parameter * (b - a);
    const double distance = (position - point).norm();
    if (distance < nearest.distance) nearest = {i, parameter, position, distance};
  }
  return nearest;
}

}  // namespace croquis
