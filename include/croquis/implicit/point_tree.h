// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"
#include "croquis/implicit/box_weight.h"

namespace croquis::implicit {

/// A k-d tree over fixed points. Equal distances are ordered by index, so that answers depend on nothing but the
/// points. Building N log N; a query log N for spread points. Reading is thread-safe. The points are copied.
class PointTree {
 public:
  /// @param points finite; @param threads that build it, 0: as many as the machine has. The tree is the same for any
  explicit PointTree(std::span<const Vec3> points, int threads = 1);

  /// The same, which can be cancelled.
  /// @throws Cancelled
  PointTree(std::span<const Vec3> points, int threads, Progress& progress);

  std::size_t size() const { return points_.size(); }

  /// The nearest point, or no_index without any.
  Index nearest(const Vec3& place) const;

  /// The `count` nearest points (all if there are fewer), nearest first.
  std::vector<Index> nearest(const Vec3& place, std::size_t count) const;

  /// All points in the box, its faces included, ascending.
  std::vector<Index> inside(const Box& box) const;

  /// Whether there are more than `most` points in the box. No more of them are looked at than that takes.
  bool holds_more_than(std::size_t most, const Box& box) const;

  std::size_t bytes() const;

 private:
  // Implicit tree: the middle of each range is its node; ranges of up to leaf_size points are leaves.
  void build(int threads, Progress& progress);
  void build_range(std::size_t begin, std::size_t end);
  std::size_t split(std::size_t begin, std::size_t end);

  std::vector<Vec3> points_;         // in tree order
  std::vector<Index> indices_;       // of tree order
  std::vector<unsigned char> axes_;  // per node, where its range is split
};

}  // namespace croquis::implicit
