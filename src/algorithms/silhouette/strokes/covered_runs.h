// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"

namespace croquis::silhouette {

/// A stretch of a line, by the parameters of its ends; of a closed line `end` may run on past the first point.
struct LineRun {
  double begin = 0;
  double end = 0;
};

/// The stretches of a line inside a closed one that it crosses, ascending; none where the two don't cross.
///
/// Where two lines nearly touch, a hand's tremble makes them cross several times, or not at all. Stretches that stay
/// within `tremble` of the closed line count as being on the other side, and the line is moved there: what is left are
/// crossings that were meant. A line that only touches the closed one is moved off it. O(n) for evenly spread samples.
/// @param step about the distance of samples
std::vector<LineRun> covered_runs(CleanLine& line, const CleanLine& cover, double tremble, double step);

/// Whether a place lies inside a closed line.
bool encloses(const CleanLine& closed, const Vec2& place);

}  // namespace croquis::silhouette
