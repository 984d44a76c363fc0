// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/placement.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "croquis/base/limits.h"

namespace croquis {
namespace {

constexpr double degrees_per_radian = 57.295779513082320877;

/// Cosine and sine, exact at right angles: what is turned by those stays on the numbers that it had.
std::array<double, 2> cosine_and_sine(double degrees) {
  const double quarters = degrees / 90;
  if (quarters == std::round(quarters) && std::abs(quarters) < 1e9) {
    constexpr std::array<double, 4> cosines{1, 0, -1, 0};
    const auto turn = static_cast<std::size_t>(((static_cast<long long>(quarters) % 4) + 4) % 4);
    return {cosines[turn], cosines[(turn + 3) % 4]};
  }
  const double angle = degrees / degrees_per_radian;
  return {std::cos(angle), std::sin(angle)};
}

Eigen::Matrix3d about_axis(int axis, double degrees) {
  const auto [cosine, sine] = cosine_and_sine(degrees);
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(next, next) = rotation(last, last) = cosine;
  rotation(last, next) = sine;
  rotation(next, last) = -sine;
  return rotation;
}

}  // namespace

Eigen::Matrix3d rotation_matrix(const Vec3& degrees) {
  return about_axis(2, degrees.z()) * about_axis(1, degrees.y()) * about_axis(0, degrees.x());
}

Vec3 rotation_degrees(const Eigen::Matrix3d& rotation) {
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  Vec3 angles(0, std::atan2(-rotation(2, 0), level), 0);
  if (level > 1e-12) {
    angles.x() = std::atan2(rotation(2, 1), rotation(2, 2));
    angles.z() = std::atan2(rotation(1, 0), rotation(0, 0));
  } else {
    angles.x() = std::atan2(-rotation(1, 2), rotation(1, 1));  // x and z turn about one axis: z stays
  }
  return degrees_per_radian * angles;
}

Affine3 Placement::map() const {
  if (*this == Placement()) return {};
  return {rotation_matrix(rotation) * scale.asDiagonal(), position};
}

std::array<Vec3, 2> transformed(const std::array<Vec3, 2>& box, const Affine3& map) {
  const Vec3 middle = map((box[0] + box[1]) / 2);
  const Vec3 reach = map.linear.cwiseAbs() * (box[1] - box[0]) / 2;
  return {middle - reach, middle + reach};
}

bool is_valid(const Placement& placement) {
  const Vec3 shrunk = placement.scale.cwiseInverse();  // places come back by these
  return are_usable_numbers(placement.position) && are_usable_numbers(placement.rotation) &&
         are_usable_numbers(placement.scale) && are_usable_numbers(shrunk) && placement.scale.minCoeff() > 0;
}

Placement moved(const Placement& placement, const Affine3& map) {
  Placement result = placement;
  result.position = map(placement.position);
  if (map.linear == Eigen::Matrix3d::Identity()) return result;
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(map.linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn = parts.matrixU() * parts.matrixV().transpose();
  const Eigen::Matrix3d before = rotation_matrix(placement.rotation);
  for (int axis = 0; axis < 3; ++axis) {
    const double stretch = (map.linear * before.col(axis)).norm();
    if (std::abs(stretch - 1) > 1e-12) result.scale(axis) *= stretch;  // what is only rotated keeps its size exactly
  }
  if (map.mirrors()) return result;
  if (!turn.isIdentity(1e-12)) result.rotation = rotation_degrees(turn * before);
  return result;
}

Placement with_point_kept(Placement changed, const Placement& before, const Vec3& point) {
  changed.position += before.map()(point) - changed.map()(point);
  return changed;
}

}  // namespace croquis
