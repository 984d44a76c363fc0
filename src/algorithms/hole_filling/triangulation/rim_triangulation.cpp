// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/rim_triangulation.h"

#include <algorithm>
#include <utility>

#include "algorithms/hole_filling/triangulation/ear_clipping.h"
#include "algorithms/hole_filling/triangulation/edge_flips.h"
#include "algorithms/hole_filling/triangulation/minimal_triangulation.h"
#include "algorithms/hole_filling/triangulation/plane_triangulation.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

RimTriangulation measured(const RimPolygon& polygon, Triangles triangles, bool is_minimal) {
  RimTriangulation result;
  result.is_minimal = is_minimal;
  for (const auto& [a, b, c] : triangles)
    result.area += triangle_area(polygon.points[a], polygon.points[b], polygon.points[c]);
  result.triangles = std::move(triangles);
  return result;
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
  return std::binary_search(blocked.begin(), blocked.end(), std::array{low, high});
}

Index RimPolygon::next(Index point) const {
  const auto end = std::upper_bound(loop_ends.begin(), loop_ends.end(), point);
  if (point + 1 != *end) return point + 1;
  return end == loop_ends.begin() ? 0 : *(end - 1);
}

std::optional<RimTriangulation> triangulate_rim(const RimPolygon& polygon, Progress& progress,
                                                const RimTriangulationOptions& options) {
  if (polygon.points.size() < 3) return std::nullopt;
  if (polygon.points.size() <= options.exact_points) {
    auto triangles = minimal_triangulation(polygon, bridged_order(polygon), progress);
    if (triangles) return measured(polygon, std::move(*triangles), polygon.loop_count() == 1);
    return std::nullopt;
  }
  auto triangles = near_minimal(polygon, progress);
  if (triangles) return measured(polygon, std::move(*triangles), false);
  return std::nullopt;
}

}  // namespace croquis::hole_filling
