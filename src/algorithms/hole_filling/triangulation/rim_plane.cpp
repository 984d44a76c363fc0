// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/rim_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"

namespace croquis::hole_filling {

RimPlane plane_of_rim(std::span<const Vec3> polygon) {
  const auto next = [&](std::size_t i) -> const Vec3& { return polygon[i + 1 == polygon.size() ? 0 : i + 1]; };
  const Vec3& origin = polygon.front();  // far from the world's origin sums would lose digits
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double edge = (next(i) - polygon[i]).norm();
    sum += edge * ((polygon[i] - origin) + (next(i) - origin)) / 2;
    length += edge;
  }
  RimPlane plane;
  plane.centre = length > 0 ? Vec3(origin + sum / length) : origin;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 middle = (polygon[i] - plane.centre + next(i) - plane.centre) / 2;
    spread += (next(i) - polygon[i]).norm() * middle * middle.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  plane.normal = axes.eigenvectors().col(0);
  plane.u = axes.eigenvectors().col(2);
  if (plane.normal.dot(area_normal(polygon)) < 0) plane.normal = -plane.normal;
  // Solvers leave the sign open: it would depend on how the rim lies in space.
  if (plane.u.dot(polygon.front() - plane.centre) < 0) plane.u = -plane.u;
  plane.v = plane.normal.cross(plane.u);
  return plane;
}

}  // namespace croquis::hole_filling
