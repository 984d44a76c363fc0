// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/fan_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

/// Fans turned further than this from their mean normal (60 degrees) aren't seen as lying in one surface.
constexpr double least_fan_agreement = 0.5;

/// Where petals begin and end, as angles counter-clockwise from the first one's beginning.
struct FanExtent {
  double begin, end;
  std::size_t petal;
};

double turn_between(const Vec3& from, const Vec3& to, const Vec3& axis) {
  const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to) - from.dot(axis) * to.dot(axis));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

std::vector<std::size_t> petal_across_gap(std::span<const Petal> petals) {
  Vec3 axis = Vec3::Zero();
  for (const Petal& petal : petals) axis += petal.normal.normalized();
  axis.normalize();
  std::vector<FanExtent> around;
  for (std::size_t i = 0; i < petals.size(); ++i) {
    if (!(petals[i].normal.normalized().dot(axis) > least_fan_agreement)) return {};
    const double begin = i == 0 ? 0 : turn_between(petals[0].first, petals[i].first, axis);
    around.push_back({begin, begin + turn_between(petals[i].first, petals[i].last, axis), i});
  }
  std::sort(around.begin(), around.end(), [](const FanExtent& a, const FanExtent& b) { return a.begin < b.begin; });
  std::vector<std::size_t> across(petals.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const bool is_last = i + 1 == around.size();
    const double limit = is_last ? 2 * std::numbers::pi : around[i + 1].begin;
    if (!(around[i].end < limit)) return {};
    across[around[i].petal] = around[is_last ? 0 : i + 1].petal;
  }
  return across;
}

}  // namespace croquis::hole_filling
