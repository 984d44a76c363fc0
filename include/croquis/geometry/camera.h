// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "croquis/geometry/affine3.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A pinhole camera without lens distortion. The world is right-handed with z up; the camera's own axes are right, down
/// and forward; picture coordinates are pixels, y down. A picture's upper left corner is (0, 0), that of a sheet may
/// lie anywhere.
///
/// A point X is at Xc = rotation · (X - eye) before the camera and at principal_point + focal_length (Xc.x, Xc.y) /
/// Xc.z in the picture.
struct Camera {
  double focal_length = 1;                                 ///< px, > 0
  Vec2 principal_point = Vec2::Zero();                     ///< px, may lie off the picture's centre
  Vec3 eye = Vec3::Zero();                                 ///< model units
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< orthonormal; rows: right, down, forward
  Vec2 image_origin = Vec2::Zero();                        ///< px, upper left corner of the picture
  Vec2 image_size = Vec2::Zero();                          ///< px, width and height

  /// How far before the camera a point lies: negative behind it. Model units.
  double depth(const Vec3& point) const { return rotation.row(2).dot(point - eye); }

  /// Where a point is seen. Meaningless where its depth is not positive.
  Vec2 project(const Vec3& point) const;

  /// The direction from the eye through a place of the picture; of depth 1, so not a unit vector.
  Vec3 ray(const Vec2& place) const;

  /// Where lines along a world axis (0..2) meet, homogeneous: (x, y, w), at infinity where w = 0.
  Vec3 vanishing_point(int axis) const;
};

/// The camera that sees the mapped world as this one sees the world. Exact for moves, turns and scales alike in all
/// directions; of other maps it follows the turn that is nearest to them.
/// @param map invertible
Camera transformed(const Camera& camera, const Affine3& map);

}  // namespace croquis
