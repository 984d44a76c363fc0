// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/ear_clipping.h"

#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/triangulation/rim_plane.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

/// How much longer a diagonal may be before a reflex turn is cut off instead.
constexpr double reflex_penalty = 1e6;

class EarClipping {
 public:
  EarClipping(const RimPolygon& rims, std::span<const Index> order)
      : rims_(rims), order_(order), next_(order.size()), previous_(order.size()), version_(order.size(), 0) {
    std::vector<Vec3> polygon;
    for (const Index point : order) polygon.push_back(rims.points[point]);
    normal_ = plane_of_rim(polygon).normal;
    const auto count = static_cast<Index>(order.size());
    for (Index i = 0; i < count; ++i) {
      next_[i] = i + 1 == count ? 0 : i + 1;
      previous_[i] = i == 0 ? count - 1 : i - 1;
    }
    for (Index i = 0; i < count; ++i) offer(i);
  }

  std::optional<std::vector<std::array<Index, 3>>> run() {
    std::vector<std::array<Index, 3>> triangles;
    std::size_t left = order_.size();
    while (left > 2 && !ears_.empty()) {
      const auto [cost, ear, version] = ears_.top();
      ears_.pop();
      if (version != version_[ear]) continue;
      triangles.push_back({order_[previous_[ear]], order_[ear], order_[next_[ear]]});
      --left;
      ++version_[ear];
      next_[previous_[ear]] = next_[ear];
      previous_[next_[ear]] = previous_[ear];
      offer(previous_[ear]);
      offer(next_[ear]);
    }
    if (left > 2) return std::nullopt;
    return triangles;
  }

 private:
  using Ear = std::tuple<double, Index, Index>;  // cost, place, version

  const Vec3& point(Index place) const { return rims_.points[order_[place]]; }

  void offer(Index place) {
    ++version_[place];
    const Index before = previous_[place];
    const Index after = next_[place];
    if (order_[before] == order_[after]) return;
    const bool is_last = next_[after] == before;
    if (!is_last && rims_.is_blocked(order_[before], order_[after])) return;
    if (!std::isfinite(triangle_cost(point(before), point(place), point(after)))) return;
    const double turn = (point(place) - point(before)).cross(point(after) - point(place)).dot(normal_);
    const double length = (point(after) - point(before)).squaredNorm();
    ears_.emplace(turn > 0 ? length : length * reflex_penalty, place, version_[place]);
  }

  const RimPolygon& rims_;
  std::span<const Index> order_;
  std::vector<Index> next_, previous_, version_;
  Vec3 normal_;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
};

}  // namespace

std::optional<std::vector<std::array<Index, 3>>> clip_ears(const RimPolygon& rims, std::span<const Index> order) {
  if (order.size() < 3) return std::nullopt;
  return EarClipping(rims, order).run();
}

}  // namespace croquis::hole_filling
