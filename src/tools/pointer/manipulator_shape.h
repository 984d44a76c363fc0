// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/tools/pointer/manipulator.h"

namespace croquis {

/// 0, 1, 2 of a handle along or about an axis, else -1.
int axis_of(ManipulatorHandle handle);

/// Of a handle in a plane the axis across it, else -1.
int normal_of(ManipulatorHandle handle);

/// Where a manipulator's handles are in one view. Both the picture and the picking are made of it.
class ManipulatorShape {
 public:
  ManipulatorShape(const Manipulator& manipulator, const ViewFrame& frame);

  /// Whether the view shows it at all.
  bool visible() const { return unit_ > 0; }

  /// Axes that point into the view have no arrow there.
  bool has_arrow(int axis) const;
  std::vector<Vec3> arrow(int axis) const;  ///< from near the middle to the tip

  /// Planes seen from their edge have no square there.
  bool has_square(int normal) const;
  std::vector<Vec3> square(int normal) const;  ///< closed

  /// The near half of the ring about an axis, or all of one that faces the eye.
  std::vector<Vec3> ring(int axis) const;
  std::vector<Vec3> circle(double radius) const;  ///< facing the eye, closed; in lengths of the handles

  ManipulatorHandle arrow_at(const Vec2& pixel, double reach) const;
  ManipulatorHandle ring_at(const Vec2& pixel, double reach) const;

  double unit() const { return unit_; }  ///< length of the handles, model units
  const Vec3& eye() const { return eye_; }

 private:
  double distance(const std::vector<Vec3>& line, const Vec2& pixel) const;
  bool holds(const std::vector<Vec3>& polygon, const Vec2& pixel) const;
  Vec3 axis(int k) const { return manipulator_.axes.col(k); }

  const Manipulator& manipulator_;
  const ViewFrame& frame_;
  double unit_ = 0;
  Vec3 eye_ = Vec3::UnitZ();    ///< unit direction to the eye
  Vec2 middle_ = Vec2::Zero();  ///< the pivot's pixel
};

}  // namespace croquis
