// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A curve as a loop walks along it.
struct DirectedCurve {
  std::shared_ptr<const ArcLengthCurve> curve;
  bool reversed = false;

  Vec3 at(double t) const { return curve->at(reversed ? 1 - t : t); }
  Vec3 tangent(double t) const;  ///< unit
};

/// Where the normals of a loop come from.
struct LoopNormals {
  Vec3 newell = Vec3::Zero();  ///< of the whole loop, unit; zero for a loop that encloses nothing
  std::vector<Vec3> corners;   ///< unit, at the start of each side: of the tangents that meet there
};

/// Where the tangents of a corner are nearly parallel its normal goes over to the loop's, without a threshold.
LoopNormals loop_normals(const std::vector<DirectedCurve>& loop);

}  // namespace croquis
