// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "croquis/implicit/box_weight.h"

namespace croquis::implicit {

struct OctreeRule {
  std::size_t leaf_points = 40;  ///< a node with more is cut in eight
  int max_depth = 20;
  /// Whether a leaf with points is cut all the same, as when its surroundings hold too many. Empty: never.
  std::function<bool(const Box& cube)> is_full;

  bool equal_leaves = false;  ///< all leaves with points at one depth: the least at which they hold leaf_points or
                              ///< fewer on average
};

/// A cube cut in eight where it holds many points. Leaves cover it without gaps; each knows its points.
class Octree {
 public:
  struct Leaf {
    Box cube;
    std::size_t begin = 0, end = 0;  ///< its points: [begin, end) of order()
    std::size_t point_count() const { return end - begin; }
  };

  Octree(std::span<const Vec3> points, const Box& cube, const OctreeRule& rule);

  const Box& cube() const { return nodes_.front().cube; }
  const std::vector<Leaf>& leaves() const { return leaves_; }
  std::span<const Index> order() const { return order_; }
  std::size_t bytes() const;

  /// The one leaf whose cube the place is in, faces belonging to the upper side; no_index outside.
  Index leaf_at(const Vec3& place) const;

  /// Calls visit(leaf) for every leaf whose cube, larger by the fraction `overlap`, holds the place; perhaps for some
  /// more. Always in the same order.
  template <typename Visit>
  void for_each_near(const Vec3& place, double overlap, Visit&& visit) const {
    if (cube().grown(overlap).contains(place)) descend(0, place, 0.25 * overlap, visit);
  }

  /// Calls visit(leaf) for every leaf whose cube meets the box.
  template <typename Visit>
  void for_each_meeting(const Box& box, Visit&& visit) const {
    meet(0, box, visit);
  }

 private:
  struct Node {
    Box cube;
    Index first = 0;  // of eight children behind one another, or the leaf
    bool is_leaf = true;
  };

  void split(std::span<const Vec3> points, std::size_t node, std::size_t begin, std::size_t end, int depth,
             const OctreeRule& rule);

  template <typename Visit>
  void descend(std::size_t node, const Vec3& place, double margin, Visit& visit) const {
    const Node& here = nodes_[node];
    if (here.is_leaf) return visit(here.first);
    // Children reach beyond their common middle by overlap / 2 of their side, that is overlap / 4 of this one's.
    const Eigen::Array3d aside = (place - here.cube.middle()).array();
    const Eigen::Array3d reach = margin * here.cube.size().array();
    for (unsigned child = 0; child < 8; ++child) {
      bool near = true;
      for (int axis = 0; axis < 3; ++axis)
        near = near && ((child >> axis & 1U) != 0 ? aside[axis] >= -reach[axis] : aside[axis] <= reach[axis]);
      if (near) descend(here.first + child, place, margin, visit);
    }
  }

  template <typename Visit>
  void meet(std::size_t node, const Box& box, Visit& visit) const {
    const Node& here = nodes_[node];
    if ((here.cube.low.array() > box.high.array()).any() || (here.cube.high.array() < box.low.array()).any()) return;
    if (here.is_leaf) return visit(here.first);
    for (Index child = 0; child < 8; ++child) meet(here.first + child, box, visit);
  }

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<Index> order_;
};

/// At most `most` of the candidates, evenly spread: one per cell of a grid over the box, the one nearest to the box'
/// middle, the lower index of equals; the cells grow until few enough are left. Ascending.
/// The result depends on the points alone, not on the candidates' order.
std::vector<Index> thinned(std::span<const Vec3> positions, std::vector<Index> candidates, const Box& box,
                           std::size_t most);

}  // namespace croquis::implicit
