// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/uniform_schemes.h"

/// Where a level ends when it is refined for ever: points, tangents and normals, one normal per side of a crease.
namespace croquis::subdivision {

/// A level with every vertex moved onto the limit surface.
struct LimitSurface {
  std::vector<Vec3> points;          ///< #V
  std::vector<Vec3> corner_normals;  ///< #C, unit length, or zero where face and tangents lie in a line;
                                     ///< corners of one vertex differ where sharp edges part them
};

/// What the limit of a level's vertices depends on, without positions: as a plan, kept while points are dragged.
///
/// Doo-Sabin. A vertex without sharp edges goes to the mean of the points that its faces' corners become: the centre of
/// a face without sharp edges, which no refinement moves. Its normal is the cross product of that face's two Fourier
/// modes of first order (Doo, Sabin 1978). A vertex of a chain goes to (A + 6V + B)/8, with one normal per side; the
/// end of a chain to the centre of the face around it; corners and pins stay. `exact` shows where that is not the limit
/// but close to it: vertices with two faces only, and chains whose sharpness runs out. Normals at corners with several
/// faces between two sharp edges are those of the faces.
///
/// Catmull-Clark, Loop: the limit masks of OpenSubdiv, one-sided along sharp edges that stay; edges whose sharpness
/// runs out count as smooth. A corner with several faces between two sharp edges may have no tangent plane: there the
/// normal is that of its fan on level 1.
class LimitPlan {
 public:
  /// @param k < plan.levels(): the limit of a level is read off the level after it
  LimitPlan(const DooSabinPlan& plan, int k, Progress& progress);

  /// @param k <= plan.levels()
  LimitPlan(const UniformPlan& plan, int k, Progress& progress);

  /// @param buffers of the plan's `positions`; @param surface its memory is used again
  /// @param threads >= 1, the same bits for any number
  void evaluate(const PositionBuffers& buffers, LimitSurface& surface, int threads = 1) const;

  /// #V, 1 where the point is the limit to rounding.
  const std::vector<std::uint8_t>& exact() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace croquis::subdivision
