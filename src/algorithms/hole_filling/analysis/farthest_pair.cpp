// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/farthest_pair.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

constexpr std::size_t leaf_size = 8;

struct TreeNode {
  Eigen::AlignedBox3d box;
  std::size_t begin = 0, end = 0;   ///< of the points
  std::size_t left = 0, right = 0;  ///< children, 0 for none (the root is never a child)
};

class FarthestPair {
 public:
  explicit FarthestPair(std::span<const Vec3> points) : points_(points.begin(), points.end()) {
    build(0, points_.size());
    sweep();
    compare(0, 0);
  }

  double squared() const { return best_; }

 private:
  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    nodes_[index].begin = begin;
    nodes_[index].end = end;
    for (std::size_t i = begin; i < end; ++i) nodes_[index].box.extend(points_[i]);
    if (end - begin <= leaf_size) return index;
    Eigen::Index axis = 0;
    nodes_[index].box.sizes().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    const std::size_t left = build(begin, middle);
    const std::size_t right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  /// A long pair to begin with: from each point to its farthest, a few times.
  void sweep() {
    Vec3 from = points_.front();
    for (int pass = 0; pass < 3; ++pass) {
      const auto farthest = std::max_element(points_.begin(), points_.end(), [&](const Vec3& a, const Vec3& b) {
        return (a - from).squaredNorm() < (b - from).squaredNorm();
      });
      best_ = std::max(best_, (*farthest - from).squaredNorm());
      from = *farthest;
    }
  }

  double bound(std::size_t a, std::size_t b) const {
    const Vec3 reach = (nodes_[a].box.max() - nodes_[b].box.min()).cwiseMax(nodes_[b].box.max() - nodes_[a].box.min());
    return reach.squaredNorm();
  }

  void compare(std::size_t a, std::size_t b) {
    if (bound(a, b) <= best_) return;
    const TreeNode& node_a = nodes_[a];
    const TreeNode& node_b = nodes_[b];
    if (node_a.left == 0 && node_b.left == 0) {
      for (std::size_t i = node_a.begin; i < node_a.end; ++i) {
        for (std::size_t j = node_b.begin; j < node_b.end; ++j)
          best_ = std::max(best_, (points_[i] - points_[j]).squaredNorm());
      }
      return;
    }
    if (a == b) {
      compare(node_a.left, node_a.right);
      compare(node_a.left, node_a.left);
      compare(node_a.right, node_a.right);
    } else if (node_b.left == 0 || (node_a.left != 0 && node_a.end - node_a.begin >= node_b.end - node_b.begin)) {
      compare(node_a.left, b);
      compare(node_a.right, b);
    } else {
      compare(a, node_b.left);
      compare(a, node_b.right);
    }
  }

  std::vector<Vec3> points_;
  std::vector<TreeNode> nodes_;
  double best_ = 0;
};

}  // namespace

double greatest_distance(std::span<const Vec3> points) {
  return points.size() < 2 ? 0 : std::sqrt(FarthestPair(points).squared());
}

}  // namespace croquis::hole_filling
