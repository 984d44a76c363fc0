// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/completion_curve.h"

#include <algorithm>

namespace croquis::silhouette {
namespace {

// Pieces that a curve is measured by before it is sampled evenly.
constexpr int dense_pieces = 64;
// Ends that turn away from each other further than this are given no longer handles.
constexpr double least_facing = -0.3;
// What follows a line stays so many samples behind it.
constexpr double depth_behind = 2;
// Next to its ends, where it comes from the line itself, it gets no deeper than this share of the way from there.
constexpr double steepness = 0.6;
constexpr int smoothing_passes = 6;

/// The place itself where it lies so deep in the surface of a line, else the place at that depth beside it.
Vec2 moved_behind(const Vec2& place, const CleanLine& bar, int bar_side, double depth) {
  const double parameter = nearest_on_line(bar.points, place, 0, bar.segment_count());
  const auto segment = static_cast<std::size_t>(parameter);
  const Vec2 at = point_at(bar.points, parameter);
  const Vec2 direction = (bar.points[(segment + 1) % bar.points.size()] - bar.points[segment]).normalized();
  const Vec2 inward = bar_side * left_of(direction);
  return inward.dot(place - at) >= depth ? place : Vec2(at + depth * inward);
}

/// Where a piece would come out beside its bar, it follows the bar within its surface instead.
Points kept_behind(Points curve, const CleanLine& bar, int bar_side, double spacing) {
  const std::vector<double> arcs = arc_lengths(curve, false);
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    const double from_end = std::min(arcs[i], arcs.back() - arcs[i]);
    curve[i] = moved_behind(curve[i], bar, bar_side, std::min(depth_behind * spacing, steepness * from_end));
  }
  TaubinOptions smoothing;
  smoothing.passes = smoothing_passes;
  return even_points(taubin_smooth(curve, false, smoothing), false, spacing);
}

}  // namespace

Cubic completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b) {
  const double distance = (b - a).norm();
  const Vec2 across = distance > 0 ? Vec2((b - a) / distance) : Vec2(1, 0);
  const double facing = 0.5 * (tangent_a.dot(across) - tangent_b.dot(across));
  const double handle = 2.0 / 3.0 * distance / (1 + std::max(facing, least_facing));
  return {a, a + handle * tangent_a, b + handle * tangent_b, b};
}

Points completion_chords(const Cubic& curve, const CompletionShape& shape, int pieces) {
  const Vec2 first = curve[1] - curve[0];
  const Vec2 last = curve[2] - curve[3];
  const Vec2 a = curve[0] + shape.reach * first;
  const Vec2 d = curve[3] + shape.reach * last;
  const Vec2 b = a + shape.handles * first;
  const Vec2 c = d + shape.handles * last;
  Points points;
  if (shape.reach > 0) points.push_back(curve[0]);
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1 - t;
    points.emplace_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
  if (shape.reach > 0) points.push_back(curve[3]);
  return points;
}

Points completion_points(const Cubic& curve, const CompletionShape& shape, double spacing, const CleanLine& bar,
                         int bar_side) {
  const Points dense = completion_chords(curve, shape, dense_pieces);
  const Points points = even_points(dense, false, std::min(spacing, length(dense, false) / 4));
  return shape.kept_behind ? kept_behind(points, bar, bar_side, spacing) : points;
}

}  // namespace croquis::silhouette
