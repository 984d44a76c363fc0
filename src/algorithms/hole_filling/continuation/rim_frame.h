// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/field.h"

namespace croquis::hole_filling {

/// A frame that turns with a site's rims, so that a lattice in it gives the same patch however the mesh lies in space:
/// z along the sum of the areas that the rims go round, x towards the vertex farthest from their middle beside that.
class RimFrame {
 public:
  explicit RimFrame(const HoleSite& site);

  Vec3 into(const Vec3& place) const { return axes_ * (place - middle_); }
  Vec3 out_of(const Vec3& place) const { return middle_ + axes_.transpose() * place; }
  std::vector<Vec3> into(std::span<const Vec3> places) const;
  std::vector<Vec3> out_of(std::span<const Vec3> places) const;

  /// A box of the frame lies in this one.
  implicit::Box around(const implicit::Box& box) const;

  /// The field of places in the frame. Keeps references to both.
  implicit::Field seen(const implicit::Field& field) const;

 private:
  Vec3 middle_ = Vec3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  // rows
};

}  // namespace croquis::hole_filling
