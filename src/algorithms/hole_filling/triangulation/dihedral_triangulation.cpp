// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/dihedral_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "algorithms/hole_filling/triangulation/apex_table.h"
#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

using Triangle = std::array<Index, 3>;

/// So many points have 1.3 million triangles.
constexpr std::size_t most_points_for_all = 200;

/// 1 - cos of angles that count as none (0.0001 degrees): rounding must not decide on flat rims.
constexpr double least_bend = 1e-12;

struct Weight {
  double bend = std::numeric_limits<double>::infinity();  ///< sum over edges of 1 - cos
  double cost = std::numeric_limits<double>::infinity();

  bool operator<(const Weight& other) const { return std::tie(bend, cost) < std::tie(other.bend, other.cost); }
};

/// The cheapest triangulations of the polygon's parts from i to k, of longer and longer parts.
class Table {
 public:
  Table(const RimPolygon& polygon, std::span<const Vec3> beyond)
      : polygon_(polygon),
        beyond_(beyond),
        size_(polygon.points.size()),
        weight_(size_ * size_),
        apex_(size_ * size_, none) {
    for (std::size_t i = 0; i + 1 < size_; ++i) weight_[at(i, i + 1)] = {0, 0};
  }

  /// @param candidates those of narrower parts first
  void fill(std::span<const Triangle> candidates, const Progress& progress) {
    CancelCheck check(progress);
    for (const Triangle& t : candidates) {
      check.step();
      offer(t);
    }
  }

  std::optional<std::vector<Triangle>> triangles() const {
    if (apex_[at(0, size_ - 1)] == none) return std::nullopt;
    return triangles_of_apexes(size_, [&](std::size_t i, std::size_t k) { return apex_[at(i, k)]; });
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::size_t at(std::size_t i, std::size_t k) const { return i * size_ + k; }

  const Vec3& point(std::size_t i) const { return polygon_.points[i]; }

  bool may_join(Index i, Index k) const { return k - i + 1 == size_ || !polygon_.is_blocked(i, k); }

  void offer(const Triangle& t) {
    const auto [i, j, k] = t;
    const Weight& before = weight_[at(i, j)];
    const Weight& after = weight_[at(j, k)];
    const double cost = before.cost + after.cost + triangle_cost(point(i), point(j), point(k));
    if (cost == std::numeric_limits<double>::infinity() || !may_join(i, k)) return;
    const Vec3 normal = normal_of(i, j, k);
    const double last = k - i + 1 == size_ ? bend_beyond(k, normal) : 0;
    const double bend = before.bend + after.bend + bend_at(i, j, normal) + bend_at(j, k, normal) + last;
    const Weight weight = {bend, cost};
    if (!(weight < weight_[at(i, k)])) return;
    weight_[at(i, k)] = weight;
    apex_[at(i, k)] = j;
  }

  Vec3 normal_of(std::size_t i, std::size_t j, std::size_t k) const {
    return (point(j) - point(i)).cross(point(k) - point(i)).normalized();
  }

  /// Between a triangle on the chord from i to k and the part's own there, or the face beyond a side.
  double bend_at(std::size_t i, std::size_t k, const Vec3& normal) const {
    const std::uint32_t apex = apex_[at(i, k)];
    return apex == none ? bend_beyond(i, normal) : bend_between(normal, normal_of(i, apex, k));
  }

  double bend_beyond(std::size_t side, const Vec3& normal) const {
    return beyond_.empty() ? 0 : bend_between(normal, beyond_[side]);
  }

  static double bend_between(const Vec3& a, const Vec3& b) {
    const double bend = 1 - a.dot(b);
    return bend < least_bend ? 0 : bend;
  }

  const RimPolygon& polygon_;
  std::span<const Vec3> beyond_;
  std::size_t size_;
  std::vector<Weight> weight_;
  std::vector<std::uint32_t> apex_;  ///< the third corner of the triangle on (i, k)
};

void put_narrow_first(std::vector<Triangle>& candidates) {
  std::ranges::sort(candidates, {}, [](const Triangle& t) { return std::tuple(t[2] - t[0], t[0], t[1]); });
}

/// All triangles on the sides that no candidate has: the points' Delaunay tetrahedra need not hold every side.
void add_on_missing_sides(Index size, std::vector<Triangle>& candidates) {
  std::vector<char> is_met(size, 0);  // the side from a point to the next
  for (const auto& [i, j, k] : candidates) {
    if (i + 1 == j) is_met[i] = 1;
    if (j + 1 == k) is_met[j] = 1;
    if (i == 0 && k + 1 == size) is_met[k] = 1;
  }
  for (Index side = 0; side < size; ++side) {
    if (is_met[side] != 0) continue;
    const Index other = side + 1 == size ? 0 : side + 1;
    for (Index apex = 0; apex < size; ++apex) {
      if (apex == side || apex == other) continue;
      Triangle t = {side, other, apex};
      std::ranges::sort(t);
      candidates.push_back(t);
    }
  }
}

std::vector<Triangle> all_triangles(Index size) {
  std::vector<Triangle> result;
  for (Index i = 0; i < size; ++i) {
    for (Index j = i + 1; j < size; ++j) {
      for (Index k = j + 1; k < size; ++k) result.push_back({i, j, k});
    }
  }
  return result;
}

std::optional<std::vector<Triangle>> cheapest(const RimPolygon& polygon, std::span<const Vec3> beyond,
                                              std::vector<Triangle> candidates, const Progress& progress) {
  put_narrow_first(candidates);
  Table table(polygon, beyond);
  table.fill(candidates, progress);
  return table.triangles();
}

}  // namespace

std::optional<std::vector<Triangle>> dihedral_triangulation(const RimPolygon& polygon, std::span<const Vec3> beyond,
                                                            std::vector<Triangle> candidates, Progress& progress) {
  const auto size = static_cast<Index>(polygon.points.size());
  if (size < 3) return std::nullopt;
  progress.check();
  add_on_missing_sides(size, candidates);
  auto triangles = cheapest(polygon, beyond, std::move(candidates), progress);
  if (triangles || size > most_points_for_all) return triangles;
  progress.check();
  return cheapest(polygon, beyond, all_triangles(size), progress);
}

}  // namespace croquis::hole_filling
