// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A half line. The direction has length 1.
struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = -Vec3::UnitZ();

  Vec3 at(double distance) const { return origin + distance * direction; }
};

/// Where a view shows a place.
struct Projected {
  Vec2 pixel = Vec2::Zero();  ///< logical pixels, y down; may lie outside the view
  double depth = 0;  ///< -1 on the near plane, 1 on the far one; nearer is less; in perspective not linear along a ray
};

/// How a view sees the model: plain data, so that tools need no camera. Perspective or parallel.
struct ViewFrame {
  Eigen::Matrix4d to_clip = Eigen::Matrix4d::Identity();    ///< model to OpenGL's clip space (-w <= x, y, z <= w)
  Eigen::Matrix4d from_clip = Eigen::Matrix4d::Identity();  ///< its inverse
  Vec2 size = {1, 1};                                       ///< of the view, logical pixels, > 0

  /// @param to_clip invertible, of any perspective or parallel view
  static ViewFrame of(const Eigen::Matrix4d& to_clip, const Vec2& size);

  /// From the near plane away from the eye, through a pixel of the view.
  Ray ray(const Vec2& pixel) const;

  /// All that is shown at a pixel, whatever its depth: in perspective from the eye on, in a parallel view a whole line,
  /// also behind the ray's origin.
  Ray sight(const Vec2& pixel) const;

  bool perspective() const { return !to_clip.row(3).head<3>().isZero(0); }

  /// Nothing for places beside or behind the eye.
  std::optional<Projected> project(const Vec3& place) const;

  /// The place shown at a pixel in a depth of Projected.
  Vec3 unproject(const Vec2& pixel, double depth) const;

  /// How long a pixel is at that place, across the view, in model units; 0 beside or behind the eye.
  double units_per_pixel(const Vec3& place) const;

  /// Unit direction from a place to the eye.
  Vec3 to_eye(const Vec3& place) const;
  Vec3 right() const;  ///< unit direction in which pixels' x grows, across the view
  Vec3 up() const;     ///< unit direction in which pixels' y falls, across the view
};

}  // namespace croquis
