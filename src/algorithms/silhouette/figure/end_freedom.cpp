// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/end_freedom.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace croquis::silhouette {
namespace {

// The tremble of an unsteady hand turns the direction of an end by up to so much (radians).
constexpr double most_misdirected = 25 * std::numbers::pi / 180;

}  // namespace

EndFreedom::EndFreedom(const Junctions& junctions, std::size_t line_count)
    : junctions_(junctions), bodies_(bodies_of_limbs(junctions, line_count)) {}

double EndFreedom::between(const HiddenEnd& a, const HiddenEnd& b) const {
  const Index body = bodies_[a.line];
  return a.line != b.line && body != no_index && bodies_[b.line] == body ? 0 : junctions_.tremble;
}

Vec2 EndFreedom::turned(const Vec2& tangent, const Vec2& towards, double freedom) {
  const double most = freedom * most_misdirected;
  const double angle = std::atan2(cross(tangent, towards), tangent.dot(towards));
  return Eigen::Rotation2Dd(std::clamp(angle, -most, most)) * tangent;
}

}  // namespace croquis::silhouette
