// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth_rows.h"

#include <cmath>

namespace croquis::silhouette {
namespace {

/// factor times the change of the gradient in a direction.
EdgeRow gradient_change(double factor, const Vec2& direction) {
  const Vec2 w = factor * direction;
  return {0, -w.x(), -w.y(), 0, w.x(), w.y()};
}

}  // namespace

EdgeRow continuity_row(const Vec2& along) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {-2 / l, -t.x(), -t.y(), 2 / l, -t.x(), -t.y()};
}

std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {gradient_change(std::sqrt(scale / l * (1 - poisson * poisson)), t),
          gradient_change(std::sqrt(scale / l * 2 * (1 - poisson)), left_of(t))};
}

}  // namespace croquis::silhouette
