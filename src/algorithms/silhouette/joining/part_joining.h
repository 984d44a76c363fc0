// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/silhouette/joining/surface_union.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Two objects, a < b.
using ObjectPair = std::pair<Index, Index>;

/// Why two parts could not become one surface.
enum class JoinFault {
  DontMeet,  ///< their surfaces have no point in common
  Unsolved,  ///< attached, one of them has no depth that can be trusted
  Unsound    ///< they have no sound union, or it lost a piece of what was drawn
};

struct FailedJoin {
  ObjectPair pair;
  JoinFault fault = JoinFault::Unsound;
};

/// Parts that became one surface.
struct JoinedParts {
  SurfaceUnion surface;
  std::vector<Index> objects;  ///< in the order in which they were joined
};

struct PartJoining {
  std::vector<JoinedParts> groups;
  std::vector<FailedJoin> failed;  ///< each pair once, ascending; none: all parts are in `groups`
};

/// Joins parts that are attached to each other, the largest first and then always the largest that is attached to what
/// is already joined. A pair that can't be joined is left out and told; its parts may still be joined to others.
/// @param parts of one or more objects each once; those in no pair are left out
/// @param pairs of the parts' objects
/// At most two unions per pair. @throws Cancelled
PartJoining join_parts(std::span<const UnionPart> parts, std::span<const ObjectPair> pairs, double sliver,
                       Progress& progress);

}  // namespace croquis::silhouette
