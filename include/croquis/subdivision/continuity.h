// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/edge_chain.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/uniform_schemes.h"

namespace croquis::subdivision {

/// The angle between the faces of each edge, #E, in radians; 0 on the boundary and for flat neighbours. What a map of
/// colours shows.
std::vector<double> edge_bends(const Level& level, std::span<const Vec3> positions);

/// How sharp the sharpest edge without a tag still is.
struct LevelContinuity {
  double greatest_bend = 0;   ///< radians
  Index edge = no_index;      ///< where, the first of several; no_index when there is none
  Vec3 place = Vec3::Zero();  ///< its middle
};

/// Edges with any sharpness left don't count. Linear time.
LevelContinuity continuity(const Level& level, std::span<const Vec3> positions);

enum class Smoothness {
  Unknown,  ///< fewer than three levels, or finite sharpness was left until the last one
  Flat,     ///< all angles are rounding
  Halving,  ///< angles shrink by 0.62 per level or faster: a continuous normal that changes evenly
  Fading,   ///< angles shrink, slower than that: a continuous normal, with curvature that grows near the element named
  Kink      ///< angles stay
};

/// Angles that shrink by less than this factor from one level to the next stay.
inline constexpr double kink_ratio = 0.9;

struct ContinuityReport {
  std::vector<LevelContinuity> levels;  ///< of level 0, 1, …
  std::vector<EdgeChain> chains;        ///< of the last level
  std::vector<ChainShape> shapes;       ///< of these chains: angle across, and left over on both sides
  Smoothness verdict = Smoothness::Unknown;
  double ratio = 0;      ///< of the last two levels' angles; infinite after a flat level
  std::string sentence;  ///< "G1 (halving): …" or "kink at …", naming the last level's element
};

/// Judges a refinement by its angles. Surfaces with a continuous normal halve them in the long run; the end of a chain
/// takes 3/4. The verdict is a measurement of the levels that are there, not a proof.
/// @param buffers of the plan's `positions`
/// @throws Cancelled
ContinuityReport continuity_report(const DooSabinPlan& plan, const PositionBuffers& buffers, Progress& progress);
ContinuityReport continuity_report(const UniformPlan& plan, const PositionBuffers& buffers, Progress& progress);

}  // namespace croquis::subdivision
