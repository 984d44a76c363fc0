// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Geometry>

#include "croquis/geometry/rational_cubic.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A place of a patch with its first derivatives.
struct PatchPoint {
  Vec3 at = Vec3::Zero();
  Vec3 du = Vec3::Zero();
  Vec3 dv = Vec3::Zero();

  /// Unit vector, or zero where the derivatives span no plane.
  Vec3 normal() const { return unit_or_zero(du.cross(dv)); }
};

/// How much each of the 20 points counts at a place, with derivatives: first the boundary's, then the inner ones.
struct GregoryWeights {
  std::array<double, 20> value{};
  std::array<double, 20> du{};
  std::array<double, 20> dv{};
};

/// A four-sided bicubic patch that has two inner points at each corner, one for each side, so that the slopes across
/// the four sides can be chosen on their own (Gregory 1974; Chiyokura and Kimura 1983).
///
/// Corners 0..3 lie at (u,v) = (0,0), (1,0), (1,1), (0,1); side i goes from corner i to corner i+1 and is the cubic
/// boundary[3i] … boundary[3i+3] (indices modulo 12). inner[2i] is next to corner i and rules the slope across side i,
/// inner[2i+1] is next to corner i too and rules the slope across side i-1.
struct GregoryPatch {
  std::array<Vec3, 12> boundary{};  ///< model units
  std::array<Vec3, 8> inner{};      ///< model units

  /// The polynomial cubic along a side, 0..3.
  RationalCubic side(int i) const;

  /// @param u,v 0..1. On the boundary the derivatives are exact, one-sided limits; at the corners too.
  PatchPoint at(double u, double v) const;
};

/// @param u,v 0..1
GregoryWeights gregory_weights(double u, double v);

}  // namespace croquis
