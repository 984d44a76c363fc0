// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/perspective/patches/face_division.h"

/// A face of n sides as n patches around its middle, divided by spokes: cubics from the middles of the sides to the
/// middle of the face.
namespace croquis {

/// The spokes of a star; everything else of its patches follows from the sides.
struct StarShape {
  Vec3 middle = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();   ///< unit, of the surface at the middle
  std::vector<Vec3> start_legs;  ///< per side, from its middle to the spoke's first handle. In the tangent plane that
                                 ///< both faces share there, if they do
  std::vector<Vec3> end_legs;    ///< per side, from the middle of the face to the spoke's last handle; at right angles
                                 ///< to the normal
};

/// A first shape: the spokes are arcs of circles that come to the middle at right angles to the face's axis there, as
/// they do on a sphere; the height of the middle is their mean.
/// @param normal of the face's mean plane
StarShape round_star(const std::vector<FaceSide>& sides, const Vec3& normal);

/// The shape with its middle elsewhere and its spokes' ends turned to it.
StarShape with_middle(const StarShape& shape, const std::vector<FaceSide>& sides, const Vec3& middle);

/// The patch at the start of side i: its sides are the first half of side i, the spoke from there, the spoke back to
/// the side before, the second half of that.
GregoryPatch star_patch(const std::vector<FaceSide>& sides, const StarShape& shape, std::size_t i);

std::vector<GregoryPatch> star_patches(const std::vector<FaceSide>& sides, const StarShape& shape);

/// The star of least energy (patch_fairing.h) near another one: of the middle, the tangent plane there and all handles
/// of the spokes.
StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start);

}  // namespace croquis
