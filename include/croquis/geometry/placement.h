// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "croquis/geometry/affine3.h"

namespace croquis {

/// Where an object stands, as people state it: what it is made of lies in a space of its own, which is scaled along
/// its axes, then rotated, then moved.
struct Placement {
  Vec3 position = Vec3::Zero();  ///< of the own space's origin, model units
  Vec3 rotation = Vec3::Zero();  ///< degrees about x, then y, then z
  Vec3 scale = Vec3::Ones();     ///< > 0

  /// From the own space to the model's.
  Affine3 map() const;

  friend bool operator==(const Placement& a, const Placement& b) {
    return a.position == b.position && a.rotation == b.rotation && a.scale == b.scale;
  }
};

/// The box around what becomes of a box (least and greatest coordinates).
std::array<Vec3, 2> transformed(const std::array<Vec3, 2>& box, const Affine3& map);

/// Whether its numbers are finite and its scales above 0, none so large or small that places would not be finite.
bool is_valid(const Placement& placement);

/// The linear part of a rotation by these angles. Exact for multiples of 90 degrees.
Eigen::Matrix3d rotation_matrix(const Vec3& degrees);

/// The angles of a rotation: about x and z in (-180, 180], about y in [-90, 90].
Vec3 rotation_degrees(const Eigen::Matrix3d& rotation);

/// Placed so that the map comes after it. Where an even map would not do, since the object is rotated, its own axes are
/// scaled as much as the map stretches them: an object is never sheared.
Placement moved(const Placement& placement, const Affine3& map);

/// With this point of its own space where it was, whatever is changed.
Placement with_point_kept(Placement changed, const Placement& before, const Vec3& point);

}  // namespace croquis
