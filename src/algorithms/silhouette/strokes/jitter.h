// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"

namespace croquis::silhouette {

/// How unsteady the hand was that drew some lines, from 0 (not more than bends explain) to 1 (the direction of a short
/// piece means nothing). Judged by the fourth differences of places a twelfth of a line's size apart, which cubic
/// curves don't have: the median over a line, as a share of its size, and the lower quartile of the lines by length.
double jitter_of(const std::vector<CleanLine>& lines, double step);

/// Outward unit direction in which an open line ends. Of lines drawn by an unsteady hand a longer piece is taken, and
/// the straight line through it: there a short piece follows the jitter. The same for both directions of drawing.
Vec2 end_direction(const CleanLine& line, bool at_start, const DrawingScale& scale);

/// Leads a line drawn by hand apart where it crosses itself. Where the two sides of something thin crossed it is led on
/// beside itself, each side back where it came from; of a curl, which goes round in the same sense as the whole line,
/// the smaller loop is cut off. What crosses itself next to one of its ends is left as it is: that end passes behind
/// it.
/// @returns the places where it crossed itself
std::vector<Vec2> uncross(CleanLine& line, const DrawingScale& scale);

}  // namespace croquis::silhouette
