// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/completion_shapes.h"

#include <cmath>

#include "algorithms/silhouette/strokes/cubic_join.h"

namespace croquis::silhouette {
namespace {

/// Even samples from a on, b left out.
void add_straight(const Vec2& a, const Vec2& b, double spacing, Points& points) {
  const int pieces = static_cast<int>(std::ceil((b - a).norm() / spacing));
  for (int i = 0; i < pieces; ++i) points.emplace_back(a + (b - a) * i / pieces);
}

/// What is bent of the curve in a shape.
std::array<Vec2, 4> bent_part(const std::array<Vec2, 4>& curve, const CompletionShape& shape, double stretch) {
  const Vec2 from = shape.reach * (curve[1] - curve[0]);
  const Vec2 to = shape.reach * (curve[2] - curve[3]);
  const double factor = shape.handles * (1 + stretch);
  return {curve[0] + from, curve[0] + from + factor * (curve[1] - curve[0]),
          curve[3] + to + factor * (curve[2] - curve[3]), curve[3] + to};
}

}  // namespace

Points shaped_points(const std::array<Vec2, 4>& curve, const CompletionShape& shape, double spacing, double stretch) {
  const std::array<Vec2, 4> bent = bent_part(curve, shape, stretch);
  if (shape.reach <= 0) return bezier_points(bent, spacing);
  Points points;
  add_straight(curve[0], bent[0], spacing, points);
  const Points round = bezier_points(bent, spacing);
  points.insert(points.end(), round.begin(), round.end() - 1);
  add_straight(bent[3], curve[3], spacing, points);
  points.push_back(curve[3]);
  return points;
}

Points shaped_chords(const std::array<Vec2, 4>& curve, const CompletionShape& shape, int pieces) {
  const std::array<Vec2, 4> bent = bent_part(curve, shape, 0);
  Points points;
  points.reserve(static_cast<std::size_t>(pieces) + 3);
  if (shape.reach > 0) points.push_back(curve[0]);
  for (int i = 0; i <= pieces; ++i) points.push_back(bezier_at(bent, static_cast<double>(i) / pieces));
  if (shape.reach > 0) points.push_back(curve[3]);
  return points;
}

}  // namespace croquis::silhouette
