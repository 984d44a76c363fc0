// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/kept_behind.h"

#include <algorithm>
#include <limits>

#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// What follows a line stays so many steps behind it.
constexpr double depth_steps = 2;
// Next to its ends, where it comes from the line itself, it gets no deeper than this share of the way from there.
constexpr double steepness = 0.6;
constexpr int smoothing_passes = 6;

struct Nearest {
  double distance = 0;  ///< into the surface positive
  Vec2 at = Vec2::Zero();
  Vec2 inward = Vec2::Zero();  ///< unit
};

Nearest nearest_on(const CleanLine& bar, int side, const Vec2& point) {
  double best = std::numeric_limits<double>::infinity();
  Nearest found;
  for (Index i = 0; i < bar.segment_count(); ++i) {
    const Vec2& a = bar.points[i];
    const Vec2& b = bar.points[(i + 1) % bar.points.size()];
    const Vec2 at = a + nearest_parameter(point, a, b) * (b - a);
    const double distance = (at - point).norm();
    if (distance >= best) continue;
    best = distance;
    found.at = at;
    found.inward = side * left_of((b - a).normalized());
    found.distance = found.inward.dot(point - at) >= 0 ? distance : -distance;
  }
  return found;
}

}  // namespace

Points kept_behind(Points curve, const CleanLine& bar, int bar_side, double step) {
  const std::vector<double> arcs = arc_lengths(curve, false);
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    const Nearest nearest = nearest_on(bar, bar_side, curve[i]);
    const double from_end = std::min(arcs[i], arcs.back() - arcs[i]);
    const double depth = std::min(depth_steps * step, steepness * from_end);
    if (nearest.distance < depth) curve[i] = nearest.at + depth * nearest.inward;
  }
  TaubinOptions smoothing;
  smoothing.passes = smoothing_passes;
  curve = taubin_smooth(curve, false, smoothing);
  Points even;
  for (const double parameter : even_parameters(curve, false, step)) even.push_back(point_at(curve, parameter));
  return even;
}

}  // namespace croquis::silhouette
