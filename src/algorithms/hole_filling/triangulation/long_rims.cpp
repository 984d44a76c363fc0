// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations of rims of any length: the least for short ones, in their plane or by their ears for long ones.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/hole_filling/editable_triangles.h"

namespace croquis::hole_filling {
namespace {

/// How much longer a diagonal may be before a reflex turn is cut off instead.
constexpr double reflex_penalty = 1e6;

/// Cuts triangles off a closed polygon in space, the shortest new diagonal first; turns that the polygon's own plane
/// calls reflex come last. n log n. Shape isn't controlled: a fallback where no plane can be used.
/// @param order as for MinimalTriangulations
std::optional<Triangles> clip_ears(const RimPolygon& rims, std::span<const Index> order) {
  using Ear = std::tuple<double, Index, Index>;  // cost, place, version
  const auto count = static_cast<Index>(order.size());
  if (count < 3) return std::nullopt;
  std::vector<Vec3> points;
  for (const Index point : order) points.push_back(rims.points[point]);
  const Vec3 normal = plane_of_rim(points).normal;
  std::vector<Index> next(count), previous(count), version(count, 0);
  for (Index i = 0; i < count; ++i) {
    next[i] = i + 1 == count ? 0 : i + 1;
    previous[next[i]] = i;
  }
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears;
  const auto offer = [&](Index place) {
    ++version[place];
    const Index before = previous[place], after = next[place];
    if (order[before] == order[after]) return;
    const bool is_last = next[after] == before;
    if (!is_last && rims.is_blocked(order[before], order[after])) return;
    if (!std::isfinite(triangle_cost(points[before], points[place], points[after]))) return;
    const double turn = (points[place] - points[before]).cross(points[after] - points[place]).dot(normal);
    const double length = (points[after] - points[before]).squaredNorm();
    ears.emplace(turn > 0 ? length : length * reflex_penalty, place, version[place]);
  };
  for (Index i = 0; i < count; ++i) offer(i);
  Triangles triangles;
  while (triangles.size() + 2 < count && !ears.empty()) {
    const auto [cost, ear, as_offered] = ears.top();
    ears.pop();
    if (as_offered != version[ear]) continue;
    triangles.push_back({order[previous[ear]], order[ear], order[next[ear]]});
    ++version[ear];
    next[previous[ear]] = next[ear];
    previous[next[ear]] = previous[ear];
    offer(previous[ear]);
    offer(next[ear]);
  }
  if (triangles.size() + 2 < count) return std::nullopt;
  return triangles;
}

constexpr std::size_t flips_per_triangle = 20;

/// A flip must gain more than rounding, relative to the cost.
constexpr double least_cost_gain = 1e-12;

/// What an impossible triangle or edge counts, so that a flip from two to one of them is a gain.
constexpr double counts_as_impossible = 1e100;

/// Flips inner edges while that lowers the sum of `triangle_cost`; triangles without area and blocked edges go first.
/// At most 20 flips per triangle.
/// @return whether no triangle without area and no blocked edge is left
bool flip_to_less_area(const RimPolygon& rims, Triangles& triangles, Progress& progress) {
  using Side = EditableTriangles::Side;
  EditableTriangles sides(triangles, rims.points.size());
  if (!sides.is_manifold(rims.points.size())) return false;
  const auto cost = [&](Index a, Index b, Index c) {
    return std::min(counts_as_impossible, triangle_cost(rims.points[a], rims.points[b], rims.points[c]));
  };
  const auto edge_cost = [&](Index a, Index b) { return rims.is_blocked(a, b) ? counts_as_impossible : 0; };
  const auto gains = [&](Side s) {
    const Index a = sides.from(s), b = sides.to(s), c = sides.apex(s), d = sides.apex(sides.twin(s));
    if (c == d) return false;
    // In a strip between two rims c and d can be joined already, on a triangle next to the two.
    for (const Side side : {sides.next(s), sides.previous(s)}) {
      if (sides.twin(side) != EditableTriangles::none && sides.apex(sides.twin(side)) == d) return false;
    }
    const double before = cost(a, b, c) + cost(b, a, d) + edge_cost(a, b);
    return cost(a, d, c) + cost(d, b, c) + edge_cost(c, d) < before * (1 - least_cost_gain);
  };
  CancelCheck cancel(progress);
  std::deque<Side> queue;
  std::vector<std::uint8_t> is_waiting(sides.count(), 0);
  const auto push = [&](Side s) {
    if (is_waiting[s] == 0) queue.push_back(s);
    is_waiting[s] = 1;
  };
  for (Side s = 0; s < sides.count(); ++s) push(s);
  for (std::size_t flips_left = flips_per_triangle * triangles.size(); !queue.empty() && flips_left > 0;) {
    cancel.step();
    const Side s = queue.front(), t = sides.twin(s);
    queue.pop_front();
    is_waiting[s] = 0;
    if (t == EditableTriangles::none || !gains(s)) continue;
    sides.flip(s);
    --flips_left;
    for (const Side around : {sides.previous(s), sides.next(s), sides.previous(t), sides.next(t)}) push(around);
  }
  triangles = sides.triangles();
  for (Side s = 0; s < sides.count(); ++s) {
    if (sides.is_inner_edge(s) && rims.is_blocked(sides.from(s), sides.to(s))) return false;
  }
  return std::ranges::all_of(triangles,
                             [&](const Triangle& t) { return cost(t[0], t[1], t[2]) < counts_as_impossible; });
}

/// Bridges between loops are found by looking at all pairs of points.
constexpr std::size_t most_bridged_points = 10000;

std::optional<Triangles> near_minimal(const RimPolygon& polygon, Progress& progress) {
  std::optional<Triangles> triangles = plane_triangulation(polygon);
  if (triangles && flip_to_less_area(polygon, *triangles, progress)) return triangles;
  if (polygon.loop_count() > 1 && polygon.points.size() > most_bridged_points) return std::nullopt;
  triangles = clip_ears(polygon, bridged_order(polygon));
  if (triangles && flip_to_less_area(polygon, *triangles, progress)) return triangles;
  return std::nullopt;
}

}  // namespace

bool RimPolygon::is_blocked(Index a, Index b) const {
  const auto [low, high] = std::minmax({a, b});
  return std::ranges::binary_search(blocked, std::array{low, high});
}

Index RimPolygon::next(Index point) const {
  const auto end = std::ranges::upper_bound(loop_ends, point);
  if (point + 1 != *end) return point + 1;
  return end == loop_ends.begin() ? 0 : *(end - 1);
}

std::optional<RimTriangulation> triangulate_rim(const RimPolygon& polygon, Progress& progress,
                                                std::size_t exact_points) {
  if (polygon.points.size() < 3) return std::nullopt;
  const bool is_short = polygon.points.size() <= exact_points;
  auto triangles = is_short ? MinimalTriangulations(polygon, bridged_order(polygon)).next(progress)
                            : near_minimal(polygon, progress);
  if (!triangles) return std::nullopt;
  RimTriangulation result{std::move(*triangles), 0, is_short && polygon.loop_count() == 1};
  for (const auto& [a, b, c] : result.triangles)
    result.area += triangle_area(polygon.points[a], polygon.points[b], polygon.points[c]);
  return result;
}

RimPlane plane_of_rim(std::span<const Vec3> polygon) {
  const auto next = [&](std::size_t i) -> const Vec3& { return polygon[i + 1 == polygon.size() ? 0 : i + 1]; };
  const Vec3& origin = polygon.front();  // far from the world's origin sums would lose digits
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double edge = (next(i) - polygon[i]).norm();
    sum += edge * ((polygon[i] - origin) + (next(i) - origin)) / 2;
    length += edge;
  }
  RimPlane plane;
  plane.centre = length > 0 ? Vec3(origin + sum / length) : origin;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 middle = (polygon[i] - plane.centre + next(i) - plane.centre) / 2;
    spread += (next(i) - polygon[i]).norm() * middle * middle.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  plane.normal = axes.eigenvectors().col(0);
  plane.u = axes.eigenvectors().col(2);
  if (plane.normal.dot(area_normal(polygon)) < 0) plane.normal = -plane.normal;
  // Solvers leave the sign open: it would depend on how the rim lies in space.
  if (plane.u.dot(polygon.front() - plane.centre) < 0) plane.u = -plane.u;
  plane.v = plane.normal.cross(plane.u);
  return plane;
}

std::optional<Triangles> plane_triangulation(const RimPolygon& rims) {
  const RimPlane plane = plane_of_rim(std::span(rims.points).first(rims.loop_ends.front()));
  std::vector<Vec2> points;
  std::vector<std::array<Index, 2>> edges;
  for (Index point = 0; point < rims.points.size(); ++point) {
    points.push_back(plane.project(rims.points[point]));
    edges.push_back({point, rims.next(point)});
  }
  const PlanarTriangulationResult result = triangulate(points, edges);
  if (!result.conflict.empty() || result.triangulation.triangles.empty()) return std::nullopt;
  Triangles triangles = triangles_inside(result.triangulation);
  // Rims that run with the patch on their left have that many triangles.
  if (triangles.size() != rims.points.size() + 2 * rims.loop_count() - 4) return std::nullopt;
  // Lowest corners first, and ascending: the order they come in changes with the rounding of coordinates, and so with
  // how the rims lie in space.
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace croquis::hole_filling
