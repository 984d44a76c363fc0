// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/curve_network.h"

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// The first control point that isn't at the start gives it, also where handles have no length.
Vec3 starting_direction(const RationalCubic& cubic) {
  for (std::size_t i = 1; i < 4; ++i) {
    if (cubic.points[i] != cubic.points[0]) return (cubic.points[i] - cubic.points[0]).normalized();
  }
  return Vec3::Zero();
}

}  // namespace

Vec3 NetworkCurve::direction_from_start() const { return starting_direction(pieces.front()); }

Vec3 NetworkCurve::direction_from_end() const { return starting_direction(pieces.back().reversed()); }

BoundingBox bounds_of(const CurveNetwork& network) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : network.vertices) box.extend(vertex);
  for (const NetworkCurve& curve : network.curves) {
    for (const RationalCubic& piece : curve.pieces) {
      for (const Vec3& point : piece.points) box.extend(point);
    }
  }
  if (box.isEmpty()) return std::nullopt;
  return std::array<Vec3, 2>{box.min(), box.max()};
}

CurveNetwork transformed(const CurveNetwork& network, const Affine3& map) {
  CurveNetwork result = network;
  for (Vec3& vertex : result.vertices) vertex = map(vertex);
  for (NetworkCurve& curve : result.curves) {
    for (RationalCubic& piece : curve.pieces) {
      for (Vec3& point : piece.points) point = map(point);
    }
  }
  return result;
}

}  // namespace croquis
