// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/offset_points.h"

#include <cmath>
#include <optional>

#include "croquis/implicit/point_tree.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

// Of d: another surface point may be nearer to the offset point by as much as rounding and a curved surface make it.
constexpr double own_fraction = 0.98;

/// The first of d, d/2, d/4 … at which the offset point's nearest surface point is its own; none if it never is.
std::optional<double> free_distance(const PointTree& tree, std::span<const Vec3> positions, Index own,
                                    const Vec3& direction, const OffsetOptions& options) {
  double distance = options.distance;
  for (int attempt = 0; attempt <= options.halvings; ++attempt, distance /= 2) {
    const Vec3 place = positions[own] + distance * direction;
    const Index nearest = tree.nearest(place);
    if ((positions[nearest] - place).norm() >= own_fraction * distance) return distance;
  }
  return std::nullopt;
}

}  // namespace

OffsetPoints with_offset_points(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                const OffsetOptions& options) {
  require_points(positions, normals);
  require_parameter(std::isfinite(options.distance) && options.distance > 0, "distance",
                    "the distance of offset points must be positive");
  OffsetPoints result;
  result.constraints.positions.assign(positions.begin(), positions.end());
  result.constraints.values.assign(positions.size(), 0.0);
  const PointTree tree(positions);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == Vec3::Zero()) continue;
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !options.both_sides) continue;
      const auto distance = free_distance(tree, positions, static_cast<Index>(i), side * normals[i], options);
      if (!distance) {
        ++result.dropped;
        continue;
      }
      if (*distance < options.distance) ++result.shortened;
      result.constraints.positions.push_back(positions[i] + side * *distance * normals[i]);
      result.constraints.values.push_back(side * *distance);
      result.origins.push_back(static_cast<Index>(i));
    }
  }
  return result;
}

}  // namespace croquis::implicit
