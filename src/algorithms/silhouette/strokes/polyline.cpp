// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

namespace croquis::silhouette {
namespace {

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

/// Calls visit(point, distance back from the end) until the distance passes `reach`.
template <typename Visit>
void walk_back(std::span<const Vec2> points, bool at_start, double reach, Visit visit) {
  const std::size_t count = points.size();
  double distance = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& point = points[at_start ? i : count - 1 - i];
    if (i > 0) distance += (point - points[at_start ? i - 1 : count - i]).norm();
    visit(point, distance);
    if (distance >= reach) return;
  }
}

}  // namespace

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

Points even_points(std::span<const Vec2> points, bool closed, double spacing) {
  Points even;
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

std::vector<Index> corners(std::span<const Vec2> points, bool closed, double reach) {
  const auto count = static_cast<Index>(points.size());
  if (count < 3) return {};
  const double spacing = croquis::length(points, closed) / (closed ? count : count - 1);
  const auto steps = static_cast<Index>(std::max(1L, std::lround(reach / spacing)));
  if (2 * steps >= count) return {};
  std::vector<double> cosine(count);
  for (Index i = 0; i < count; ++i) cosine[i] = turn_cosine(points, closed, i, steps);
  std::vector<Index> found;
  const double threshold = std::cos(std::numbers::pi / 3);
  for (Index i = 0; i < count; ++i) {
    bool sharpest = cosine[i] < threshold;
    for (Index k = 1; k <= steps && sharpest; ++k) {
      sharpest = cosine[i] < cosine[(i + count - k) % count] && cosine[i] <= cosine[(i + k) % count];
    }
    if (sharpest) found.push_back(i);
  }
  return found;
}

std::vector<EndHit> end_hits(std::span<const Vec2> back, std::span<const Vec2> headings, double reach, const Vec2& a,
                             const Vec2& b) {
  const Vec2& end = back.front();
  std::vector<EndHit> hits;
  double walked = 0;
  for (std::size_t k = 0; k + 1 < back.size() && walked < reach; ++k) {
    const Vec2 piece = back[k + 1] - back[k];
    if (cross_properly(back[k], back[k + 1], a, b)) {
      const double fraction = crossing_fraction(back[k], back[k + 1], a, b);
      hits.push_back({EndHit::Way::Across, -(walked + fraction * piece.norm()), back[k] + fraction * piece});
    }
    walked += piece.norm();
  }
  for (const Vec2& heading : headings) {
    const Vec2 ahead = end + reach * heading;
    if (!cross_properly(end, ahead, a, b)) continue;
    const double fraction = crossing_fraction(end, ahead, a, b);
    hits.push_back({EndHit::Way::Ahead, fraction * reach, end + fraction * (ahead - end)});
  }
  const Vec2 nearest = nearest_on_segment(end, a, b);
  hits.push_back({EndHit::Way::Beside, (nearest - end).norm(), nearest});
  return hits;
}

double size_of(std::span<const Vec2> points, bool closed) {
  const std::size_t count = points.size();
  double length = 0;
  Vec2 first = Vec2::Zero();
  double second = 0;
  // Relative to the first point, against cancellation; each segment has its exact moments.
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const Vec2 a = points[i] - points[0];
    const Vec2 b = points[(i + 1) % count] - points[0];
    const double piece = (b - a).norm();
    length += piece;
    first += piece / 2 * (a + b);
    second += piece / 3 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
  }
  if (!(length > 0)) return 0;
  const Vec2 middle = first / length;
  return std::sqrt(12 * std::max(0.0, second / length - middle.squaredNorm()));
}

std::optional<double> typical_spacing(std::span<const Vec2> places, const std::vector<char>& counts) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < places.size() && places.size() > 1; ++i) {
    if (counts[i] == 0) continue;
    nearest.push_back(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k != i) nearest.back() = std::min(nearest.back(), (places[k] - places[i]).norm());
    }
  }
  if (nearest.empty()) return std::nullopt;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

Vec2 end_tangent(std::span<const Vec2> points, bool at_start, double reach) {
  const Vec2 end = at_start ? points.front() : points.back();
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
  int used = 0;
  // Position(s) = end + a s + b s², weighted least squares in a and b.
  walk_back(points, at_start, reach, [&](const Vec2& point, double distance) {
    if (distance <= 0) return;
    const double share = std::max(0.05, 1 - distance / reach);
    const Eigen::Vector2d basis(distance, distance * distance / reach);
    normal += share * share * basis * basis.transpose();
    right += share * share * basis * (point - end).transpose();
    ++used;
  });
  if (used < 3) return end_chord(points, at_start, reach);
  const Vec2 back = normal.ldlt().solve(right).row(0).transpose();
  const double norm = back.norm();
  return std::isfinite(norm) && norm > 0 ? Vec2(-back / norm) : end_chord(points, at_start, reach);
}

Vec2 end_chord(std::span<const Vec2> points, bool at_start, double reach) {
  const Vec2 end = at_start ? points.front() : points.back();
  Vec2 back = end;
  walk_back(points, at_start, reach, [&](const Vec2& point, double) {
    if (point != end) back = point;
  });
  const double norm = (end - back).norm();
  return norm > 0 ? Vec2((end - back) / norm) : Vec2(1, 0);
}

}  // namespace croquis::silhouette
