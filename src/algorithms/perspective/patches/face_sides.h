// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/perspective/gregory_patches.h"

namespace croquis {

/// A side of a face in two halves that meet at its middle.
struct FaceSide {
  PatchSide first, second;
  bool whole = true;  ///< one cubic, `full`
  std::array<Vec3, 4> full{};
  Vec3 middle = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();  ///< unit, along the side at its middle
  Vec3 inwards = Vec3::Zero();  ///< unit, into the face at the middle: half way between the slopes at the ends

  /// The side as that of a patch over the whole face. Only where it is one cubic.
  PatchSide as_one() const { return {full, first.common, {first.across[0], second.across[1]}}; }
};

/// The sides of a face's outer loop on their way around.
std::vector<FaceSide> face_sides(const Brep& brep, const BrepFace& face);

}  // namespace croquis
