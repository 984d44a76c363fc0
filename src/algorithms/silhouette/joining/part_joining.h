// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/silhouette/surface/shell.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Why two parts could not become one surface.
enum class JoinFault {
  DontMeet,  ///< their surfaces have no point in common, or one lies within the other
  Unsolved,  ///< attached, one of them has no depth that can be trusted
  Unsound    ///< they have no sound union, or it lost a piece of what was drawn
};

struct FailedJoin {
  ObjectPair pair;
  JoinFault fault = JoinFault::Unsound;
};

struct PartJoining {
  std::vector<Shell> groups;       ///< of at least two parts each; they must be checked all the same
  std::vector<FailedJoin> failed;  ///< each pair once, ascending; none: all parts are in `groups`
};

/// Joins parts that are attached to each other, the largest first and then always the largest that is attached to what
/// is already joined. A pair that can't be joined is left out and reported; its parts may still be joined to others.
///
/// Exact predicates; new points are rounded to doubles. Slivers along the seams are removed after each part, which
/// moves the seams by no more than the length given: a later part that crosses a seam of slivers would find that they
/// cut one another, and so would a file that rounds to its digits.
/// @param parts  of different single objects, closed, outward, free of self-intersections; those in no pair are left
/// out
/// @param pairs  of the parts' objects
/// @param sliver seam edges shorter than this may go, sketch units
/// At most two unions per pair, each O(n log n) in practice. @throws Cancelled
PartJoining join_parts(std::span<const Shell* const> parts, std::span<const ObjectPair> pairs, double sliver,
                       Progress& progress);

}  // namespace croquis::silhouette
