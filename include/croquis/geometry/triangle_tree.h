// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// The point of a triangle that is nearest to a place.
struct TriangleFoot {
  Index triangle = no_index;  ///< none was near enough
  double distance = std::numeric_limits<double>::infinity();
  Vec3 point = Vec3::Zero();
  int corner = -1;  ///< 0..2 where the foot is that corner
  int edge = -1;    ///< 0..2 where it lies on the edge that begins at that corner
};

/// The foot on one triangle, which may have no area.
TriangleFoot foot_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& place);

/// A tree of boxes over triangles. Of equal distances the lowest triangle's counts, so that results depend on nothing
/// but the triangles. Building n log n; reading is thread-safe.
class TriangleTree {
 public:
  using Filter = std::function<bool(Index)>;

  /// @throws Cancelled
  explicit TriangleTree(std::vector<std::array<Vec3, 3>> triangles, const Progress& progress = {});

  const std::array<Vec3, 3>& triangle(Index t) const { return triangles_[t]; }

  /// The nearest triangle that counts, no farther than `farthest`.
  /// @param counts asked for triangles that might be the nearest; empty: all count
  TriangleFoot nearest(const Vec3& place, double farthest, const Filter& counts = {}) const;

 private:
  void build(std::size_t begin, std::size_t end, const Progress& progress);
  void offer(Index t, const Vec3& place, const Filter& counts, TriangleFoot& best) const;
  void descend(std::size_t begin, std::size_t end, const Vec3& place, const Filter& counts, TriangleFoot& best) const;

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Index> order_;                 ///< the middle of each range is its node
  std::vector<Eigen::AlignedBox3d> bounds_;  ///< per node, of its range
};

}  // namespace croquis
