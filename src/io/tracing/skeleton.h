// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/geometry/vector.h"
#include "io/tracing/pixel_grid.h"

namespace croquis::tracing {

/// A place where middle lines meet.
struct SkeletonNode {
  Vec2 place = Vec2::Zero();  ///< pixels
  double half_width = 0;      ///< pixels from there to the border of the ink
};

/// A middle line between two nodes or free ends.
struct Branch {
  std::vector<Vec2> points;                        ///< pixels, the nodes not among them; at least one
  std::array<Index, 2> nodes{no_index, no_index};  ///< at its beginning and at its end
  bool closed = false;                             ///< it ends where it begins, without a node
};

struct Skeleton {
  std::vector<SkeletonNode> nodes;
  std::vector<Branch> branches;
};

/// Which branch, and which of its two ends: even numbers are beginnings.
inline Index end_at(std::size_t branch, std::size_t side) { return static_cast<Index>(2 * branch + side); }

/// The ends of branches at each node.
std::vector<std::vector<Index>> ends_at_nodes(const Skeleton& skeleton);

/// The branches of lines that are one pixel wide.
/// @param distances of the ink, as distances_to_outside gives them
Skeleton skeleton_of(const Mask& thin, const PixelGrid<int>& distances);

/// Removes what thinning leaves beside the middle of lines: spurs that hardly reach out of the ink, and, by making one
/// node of two, pieces between nodes that are no longer than lines are wide, or that two crossing lines share.
Skeleton simplified(Skeleton skeleton);

}  // namespace croquis::tracing
