// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/predicates.h"

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

/// The piece of a line between two kept points, cut evenly; its last point belongs to the next piece.
void append_even(std::span<const double> arcs, Index first, Index last, double spacing,
                 std::vector<double>& parameters) {
  const double length = arcs[last] - arcs[first];
  const int count = std::max(1, static_cast<int>(std::lround(length / spacing)));
  Index segment = first;
  for (int i = 0; i < count; ++i) {
    const double place = arcs[first] + length * i / count;
    while (segment + 1 < last && arcs[segment + 1] <= place) ++segment;
    const double span = arcs[segment + 1] - arcs[segment];
    const double fraction = span > 0 ? std::clamp((place - arcs[segment]) / span, 0.0, 1.0) : 0.0;
    parameters.push_back(segment + fraction);
  }
}

/// Cosine of the turn at a point between the chords that reach `steps` points back and on; 1 near an open end.
double turn_cosine(std::span<const Vec2> points, bool closed, Index i, Index steps) {
  const auto count = static_cast<Index>(points.size());
  if (!closed && (i < steps || i + steps >= count)) return 1;
  const Vec2 before = points[i] - points[(i + count - steps % count) % count];
  const Vec2 after = points[(i + steps) % count] - points[i];
  const double norm = before.norm() * after.norm();
  return norm > 0 ? before.dot(after) / norm : 1;
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

Vec2 point_at(std::span<const Vec2> points, double parameter) {
  const auto segment = static_cast<std::size_t>(parameter);
  const double fraction = parameter - static_cast<double>(segment);
  const Vec2& a = points[segment % points.size()];
  if (fraction <= 0) return a;
  return a + fraction * (points[(segment + 1) % points.size()] - a);
}

std::vector<double> even_parameters(std::span<const Vec2> points, bool closed, double spacing,
                                    std::span<const Index> fixed) {
  const std::vector<double> arcs = arc_lengths(points, closed);
  std::vector<double> parameters;
  const auto last = static_cast<Index>(arcs.size() - 1);
  std::vector<Index> stops{0};
  for (const Index stop : fixed) {
    if (stop > stops.back() && stop < last) stops.push_back(stop);
  }
  stops.push_back(last);
  // A closed line that keeps no point starts anywhere; at least three samples make it a region.
  if (closed && stops.size() == 2) spacing = std::min(spacing, arcs.back() / 6);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) append_even(arcs, stops[i], stops[i + 1], spacing, parameters);
  if (!closed) parameters.push_back(last);
  return parameters;
}

std::vector<Vec2> even_points(std::span<const Vec2> points, bool closed, double spacing) {
  std::vector<Vec2> even;
  for (const double parameter : even_parameters(points, closed, spacing)) even.push_back(point_at(points, parameter));
  return even;
}

double parameter_along(std::span<const Vec2> points, bool from_start, double distance) {
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const std::size_t segment = from_start ? i : last - 1 - i;
    const double length = (points[segment + 1] - points[segment]).norm();
    if (length > distance)
      return static_cast<double>(from_start ? i : last - i) + (from_start ? 1 : -1) * distance / length;
    distance -= length;
  }
  return from_start ? static_cast<double>(last) : 0;
}

double nearest_on_line(std::span<const Vec2> points, const Vec2& place, Index first, Index last) {
  double least = std::numeric_limits<double>::infinity();
  double found = first;
  for (Index i = first; i < last; ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    const double fraction = nearest_parameter(place, a, b);
    const double distance = (a + fraction * (b - a) - place).norm();
    if (distance >= least) continue;
    least = distance;
    found = i + std::min(fraction, 1 - 1e-9);
  }
  return found;
}

std::vector<Index> corners_of(std::span<const Vec2> points, bool closed, double reach, double angle) {
  const auto count = static_cast<Index>(points.size());
  if (count < 3) return {};
  const double spacing = length(points, closed) / (closed ? count : count - 1);
  const auto steps = static_cast<Index>(std::max(1L, std::lround(reach / spacing)));
  if (2 * steps >= count) return {};
  std::vector<double> cosine(count);
  for (Index i = 0; i < count; ++i) cosine[i] = turn_cosine(points, closed, i, steps);
  std::vector<Index> found;
  const double threshold = std::cos(angle);
  for (Index i = 0; i < count; ++i) {
    bool sharpest = cosine[i] < threshold;
    for (Index k = 1; k <= steps && sharpest; ++k) {
      sharpest = cosine[i] < cosine[(i + count - k) % count] && cosine[i] <= cosine[(i + k) % count];
    }
    if (sharpest) found.push_back(i);
  }
  return found;
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

int winding_number(std::span<const Vec2> polygon, const Vec2& place) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const bool upwards = b.y() > place.y();
    if ((a.y() > place.y()) == upwards) continue;
    if ((orientation(a, b, place) > 0) == upwards) winding += upwards ? 1 : -1;
  }
  return winding;
}

}  // namespace croquis
