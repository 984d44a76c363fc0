// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace croquis::silhouette {
std::vector<EndHit> end_hits(std::span<const Vec2> back, std::span<const Vec2> headings, double reach, const Vec2& a,
                             const Vec2& b) {
  const Vec2& end = back.front();
  std::vector<EndHit> hits;
  double walked = 0;
  for (std::size_t k = 0; k + 1 < back.size() && walked < reach; ++k) {
    const Vec2 piece = back[k + 1] - back[k];
    if (segments_cross(back[k], back[k + 1], a, b)) {
      const double fraction = crossing_fraction(back[k], back[k + 1], a, b);
      hits.push_back({EndHit::Way::Across, -(walked + fraction * piece.norm()), back[k] + fraction * piece});
    }
    walked += piece.norm();
  }
  for (const Vec2& heading : headings) {
    const Vec2 ahead = end + reach * heading;
    if (!segments_cross(end, ahead, a, b)) continue;
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
  const Vec2& end = end_of(points, at_start);
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
  const Vec2& end = end_of(points, at_start);
  Vec2 back = end;
  walk_back(points, at_start, reach, [&](const Vec2& point, double) {
    if (point != end) back = point;
  });
  const double norm = (end - back).norm();
  return norm > 0 ? Vec2((end - back) / norm) : Vec2(1, 0);
}

}  // namespace croquis::silhouette
