// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/surface_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <unordered_map>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

/// Dijkstra over the edges of the view. The map is only looked up, so that its order reaches no result.
class Reach {
 public:
  Reach(const HoleSite& site, double reach)
      : view_(site.analysis->view), positions_(site.mesh->positions), reach_(reach) {
    for (const Index id : site.holes) {
      for (const Index corner : site.analysis->holes[id].corners) {
        offer(corner, 0);
        offer(SurfaceView::next(corner), 0);
      }
    }
  }

  std::vector<ReachedVertex> run() {
    std::vector<ReachedVertex> reached;
    while (!queue_.empty()) {
      const auto [distance, place, vertex, corner] = queue_.top();
      queue_.pop();
      if (distance > known_.at(vertex)) continue;
      known_[vertex] = -1;  // done: nothing is nearer
      fan_.assign(1, corner / 3);
      add_fan(view_, corner, fan_);
      std::sort(fan_.begin(), fan_.end());
      fan_.erase(std::unique(fan_.begin(), fan_.end()), fan_.end());
      reached.push_back({vertex, distance, normal_at(vertex), corner});
      for (const Index triangle : fan_) offer_neighbours(triangle, vertex, distance);
    }
    return reached;
  }

 private:
  // Distance, place, vertex, a corner there: of places equally far the one with the least coordinates comes first, so
  // that the numbers of vertices tell nothing.
  using Entry = std::tuple<double, std::array<double, 3>, Index, Index>;

  void offer(Index corner, double distance) {
    const Index vertex = view_.origin(corner);
    const auto [entry, is_new] = known_.try_emplace(vertex, distance);
    if (!is_new && distance >= entry->second) return;
    entry->second = distance;
    const Vec3& place = positions_[vertex];
    queue_.emplace(distance, std::array{place.x(), place.y(), place.z()}, vertex, corner);
  }

  void offer_neighbours(Index triangle, Index vertex, double distance) {
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
      const double further = distance + (positions_[view_.origin(corner)] - positions_[vertex]).norm();
      if (further <= reach_) offer(corner, further);
    }
  }

  Vec3 normal_at(Index vertex) const {
    Vec3 sum = Vec3::Zero();
    for (const Index triangle : fan_) {
      if ((view_.flags[triangle] & (SurfaceView::no_area | SurfaceView::is_sliver)) != 0) continue;
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        if (view_.origin(corner) != vertex) continue;
        const Vec3 out = positions_[view_.target(corner)] - positions_[vertex];
        const Vec3 in = positions_[view_.origin(SurfaceView::previous(corner))] - positions_[vertex];
        const Vec3 across = out.cross(in);
        const double length = across.norm();
        if (length > 0) sum += std::atan2(length, out.dot(in)) / length * across;
      }
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
  }

  const SurfaceView& view_;
  const std::vector<Vec3>& positions_;
  double reach_;
  std::unordered_map<Index, double> known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<Index> fan_;
};

}  // namespace

std::vector<ReachedVertex> reach_from_rims(const HoleSite& site, double reach) { return Reach(site, reach).run(); }

}  // namespace croquis::hole_filling
