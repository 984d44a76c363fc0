// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// The end of a line (the stem) that stops where another one (the bar) passes in front: a T-junction.
struct HiddenEnd {
  Index line = 0;
  bool at_start = false;
  Index bar = 0;
  double bar_parameter = 0;     ///< place on the bar's samples
  Vec2 at = Vec2::Zero();       ///< on the bar
  Vec2 tangent = Vec2::Zero();  ///< outward, unit: into the bar's surface
  int bar_side = 1;             ///< the bar's surface lies on its left (+1) or right (-1)
};

/// A piece of contour between two ends that is known though it is hidden.
struct GivenPiece {
  Index from = 0;  ///< positions in Junctions::ends
  Index to = 0;
  Points points;
  Index stroke = 0;
};

struct Junctions {
  std::vector<HiddenEnd> ends;  ///< by line, its start first
  std::vector<int> sides;       ///< per line: surface on its left (+1), right (-1), or not given by any stem (0)
  std::vector<GivenPiece> given;
  double jitter = 0;      ///< of the hand, see `jitter_of`
  LineFindings findings;  ///< E_NO_LABELLING, E_CROSS, E_TOUCH; E_HIDDEN_STROKE of those that join no two ends
};

/// Trims or extends the lines to what their ends pass behind; targets then lie where lines end.
void meet_bars(std::vector<CleanLine>& lines, const DrawingScale& scale);

/// What every open end passes behind, and where the surfaces of bars lie (Cordier, Seo, Cho 2006, section 3; the side
/// rule is Williams 1994).
/// @param lines  have met their bars and end on them; they are carried on a little past them
/// @param hidden strokes of kind "hidden" (stroke_data.h): each is the hidden contour between the two ends that are
/// nearest to its own, and is moved so that it begins and ends there
Junctions find_junctions(const Drawing& drawing, std::vector<CleanLine>& lines,
                         const std::vector<SampledStroke>& hidden, const VisibleCrossings& order,
                         const DrawingScale& scale, const Progress& progress);

}  // namespace croquis::silhouette
