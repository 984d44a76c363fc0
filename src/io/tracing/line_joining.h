// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/tracing/skeleton.h"

namespace croquis::tracing {

/// The middle of one drawn line.
struct TracedLine {
  std::vector<Vec2> points;  ///< pixels
  bool closed = false;
};

/// Joins branches to the lines that they were drawn as: two that go straight on at a node, and free ends that face each
/// other across a gap. What other branches there are at a node end at it.
/// @param half_width pixels, the usual one of a line
std::vector<TracedLine> joined_lines(const Skeleton& skeleton, double half_width);

}  // namespace croquis::tracing
