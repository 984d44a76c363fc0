// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/swept_limbs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace croquis::silhouette {
namespace {

constexpr double max_tilt = 2;     // a limb that points at the viewer would otherwise become a spike
constexpr int balls_per_edge = 4;  // nodes are a third of a radius apart

/// What the balls over one place reach.
struct Heights {
  double top;
  double bottom;
  double level;  ///< top of the same balls, all at height 0
};

class SweptBalls {
 public:
  SweptBalls(const Skeleton& skeleton, const Eigen::VectorXd& node_z)
      : skeleton_(skeleton),
        z_(node_z),
        neighbours_(skeleton.nodes.size()),
        last_seen_(skeleton.nodes.size(), no_index) {
    for (const auto& [a, b] : skeleton.edges) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    }
  }

  /// Only balls that the skeleton leads to count: others above the same place belong to other sheets.
  Heights over(Index node) {
    const SkeletonNode& centre = skeleton_.nodes[node];
    Heights heights{z_[node] + centre.radius, z_[node] - centre.radius, centre.radius};
    queue_.assign(1, node);
    last_seen_[node] = node;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const Index from = queue_[head];
      for (const Index to : neighbours_[from]) {
        if (!add_edge(from, to, centre.position, heights) || last_seen_[to] == node) continue;
        last_seen_[to] = node;
        queue_.push_back(to);
      }
    }
    return heights;
  }

 private:
  /// @return whether the last ball still covers the place
  bool add_edge(Index from, Index to, const Vec2& place, Heights& heights) const {
    const SkeletonNode& a = skeleton_.nodes[from];
    const SkeletonNode& b = skeleton_.nodes[to];
    bool covered = false;
    for (int i = 1; i <= balls_per_edge; ++i) {
      const double part = static_cast<double>(i) / balls_per_edge;
      const double radius = (1 - part) * a.radius + part * b.radius;
      const double square = radius * radius - ((1 - part) * a.position + part * b.position - place).squaredNorm();
      covered = square > 0;
      if (!covered) continue;
      const double height = std::sqrt(square);
      const double z = (1 - part) * z_[from] + part * z_[to];
      heights.top = std::max(heights.top, z + height);
      heights.bottom = std::min(heights.bottom, z - height);
      heights.level = std::max(heights.level, height);
    }
    return covered;
  }

  const Skeleton& skeleton_;
  const Eigen::VectorXd& z_;
  std::vector<std::vector<Index>> neighbours_;
  std::vector<Index> last_seen_;  ///< per node, the node whose walk met it last
  std::vector<Index> queue_;
};

}  // namespace

SweptLimbs swept_limbs(const Skeleton& skeleton, const Eigen::VectorXd& node_z) {
  SweptBalls balls(skeleton, node_z);
  SweptLimbs limbs{Eigen::VectorXd(node_z.size()), Eigen::VectorXd(node_z.size())};
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    const Heights heights = balls.over(n);
    limbs.tilt[n] = std::clamp((heights.top - heights.bottom) / (2 * heights.level), 1.0, max_tilt);
    limbs.lift[n] = (heights.top + heights.bottom) / 2 - node_z[n];
  }
  return limbs;
}

}  // namespace croquis::silhouette
