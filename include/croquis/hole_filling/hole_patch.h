// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// New surface that closes one hole, or several holes that belong together (a hole and its islands, both ends of a
/// tunnel). It refers to the mesh and is in no mesh yet.
struct HolePatch {
  std::vector<Index> holes;                     ///< ids in the analysis, ascending
  std::vector<Vec3> points;                     ///< new vertices
  std::vector<std::array<Index, 3>> triangles;  ///< corners below #V are vertices of the mesh, #V + i is points[i]
  std::string method = {};                      ///< how it was made, where its maker's name isn't enough; else empty
  double expected_error = std::numeric_limits<double>::quiet_NaN();  ///< mean distance to the surface that was there,
                                                                     ///< guessed by cross-validation; model units
  std::vector<Index> arrives_at = {};  ///< further holes that the surface continued from these arrives at, ascending:
                                       ///< those belong to them, and there are no triangles
  bool rises_too_far = false;  ///< over its hole, see rises_too_far(): it isn't wanted, and there are no triangles
  std::vector<std::size_t> domain_points = {};  ///< of each function that it lies on: the points it was fitted to
};

/// Beyond this angle across the rim a wedge of less than 60 degrees is left between patch and surface, which scans of
/// things hardly ever have: of 95 patches of scans three bent by more than 85 degrees, and all of them by more than
/// 130. Radians.
inline constexpr double doubtful_fold = 120 * std::numbers::pi / 180;

/// What the verification of a patch found. Angles in radians.
struct PatchVerdict {
  std::string fault;           ///< empty for a sound patch, else why it can't be taken
  double min_angle = 0;        ///< of all corners of the patch
  double max_normal_jump = 0;  ///< greatest angle between the faces on the two sides of a rim edge

  bool is_sound() const { return fault.empty(); }
};

}  // namespace croquis::hole_filling
