// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {

/// By how much a bulge of 1 turns the surface at the rim (radians; 45 degrees): a disc becomes a dome of 0.2 diameters.
inline constexpr double angle_of_bulge = 0.7853981633974483;

/// The surface around a site, turned about its rims as about a hinge, so that what continues it goes outwards (or
/// inwards): the shape of a patch is changed by changing what it is fitted to. Rim points stay where they are.
class RimHinge {
 public:
  /// @param bulge -1..1, + turns the continuation to the side that the faces look to
  RimHinge(const HoleSite& site, double bulge);

  /// Where a point of the surface around comes to: turned about the nearest rim vertices, nearer ones counting more.
  Vec3 place(const Vec3& point) const;

  /// Its normal there.
  Vec3 normal(const Vec3& point, const Vec3& normal) const;

 private:
  struct Turn {
    Vec3 about = Vec3::Zero();  ///< unit
    Vec3 pivot = Vec3::Zero();
    double weight = 0;
  };
  std::vector<Turn> turns_at(const Vec3& point) const;

  std::vector<Vec3> points_;
  std::vector<Vec3> tangents_;  ///< unit, along the polygon of the site
  implicit::PointTree tree_;
  double angle_;
};

}  // namespace croquis::hole_filling
