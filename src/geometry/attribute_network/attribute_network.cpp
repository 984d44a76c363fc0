// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/attribute_network.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace croquis {
namespace {

/// The loop walked along the other way. The domain's corner k becomes its corner (n - k) modulo n.
void turn_loop(AttributeFace& face) {
  std::ranges::reverse(face.loop);
  for (AttributeSide& side : face.loop) side.reversed = !side.reversed;
}

FanPlace turned(const FanPlace& fan, std::size_t corners) { return {corners - 1 - fan.corner, fan.b, fan.a}; }

void turn_faces(AttributeNetwork& network) {
  for (AttributeFace& face : network.faces) turn_loop(face);
  for (PointAttribute& point : network.points) {
    const std::size_t corners = domain_corners(network.faces[point.face]);
    if (point.fan && point.fan->corner < corners) point.fan = turned(*point.fan, corners);
  }
}

/// How normals go: by the inverse transpose, lengths kept.
class NormalMap {
 public:
  explicit NormalMap(const Affine3& map) : matrix_(map.linear.inverse().transpose()) {}

  Vec3 operator()(const Vec3& normal) const { return normal.norm() * unit_or_zero(matrix_ * normal); }

 private:
  Eigen::Matrix3d matrix_;
};

void scale(std::optional<double>& length, double factor) {
  if (length) *length *= factor;
}

}  // namespace

std::vector<Vec3> control_polygon(const AttributeNetwork& network, const AttributeCurve& curve) {
  if (!curve.control.empty()) return curve.control;
  return {network.nodes[curve.from].point, network.nodes[curve.to].point};
}

Vec3 bezier_point(std::vector<Vec3> control, double t) {
  for (std::size_t left = control.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) control[i] = (1 - t) * control[i] + t * control[i + 1];
  }
  return control[0];
}

std::size_t domain_corners(const AttributeFace& face) { return face.loop.size() == 2 ? 4 : face.loop.size(); }

BoundingBox bounds_of(const AttributeNetwork& network) {
  Eigen::AlignedBox3d box;
  for (const AttributeNode& node : network.nodes) box.extend(node.point);
  for (const AttributeCurve& curve : network.curves) {
    for (const Vec3& point : curve.control) box.extend(point);
  }
  for (const PointAttribute& point : network.points) box.extend(point.point);
  if (box.isEmpty()) return std::nullopt;
  return std::array<Vec3, 2>{box.min(), box.max()};
}

AttributeNetwork transformed(const AttributeNetwork& network, const Affine3& map) {
  if (map.is_identity()) return network;
  const NormalMap normal_map(map);
  const double growth = std::cbrt(std::abs(map.linear.determinant()));
  AttributeNetwork result = network;
  scale(result.tolerance, growth);
  for (AttributeNode& node : result.nodes) node.point = map(node.point);
  for (AttributeCurve& curve : result.curves) {
    for (Vec3& point : curve.control) point = map(point);
  }
  for (AttributeFace& face : result.faces) {
    for (InnerCurve& inner : face.inner) scale(inner.radius, growth);
  }
  for (PointAttribute& point : result.points) {
    point.point = map(point.point);
    scale(point.radius, growth);
    if (point.normal) point.normal = normal_map(*point.normal);
  }
  for (SlopeAttribute& slope : result.slopes) {
    for (Vec3& normal : slope.normals) normal = normal_map(normal);
  }
  if (map.mirrors()) turn_faces(result);
  return result;
}

}  // namespace croquis
