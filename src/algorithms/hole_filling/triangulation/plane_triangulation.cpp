// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/plane_triangulation.h"

#include <algorithm>
#include <span>

#include "algorithms/hole_filling/triangulation/rim_plane.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis::hole_filling {
namespace {

/// A triangulation of all points whose rims run with the patch on their left has 2 (loops - 1) - 2 + points triangles.
std::size_t expected_triangles(const RimPolygon& rims) { return rims.points.size() + 2 * rims.loop_count() - 4; }

/// Each with its lowest corner first, and ascending: the order they come in changes with the rounding of coordinates,
/// and so with how the rims lie in space.
void bring_in_order(std::vector<std::array<Index, 3>>& triangles) {
  for (auto& t : triangles) std::ranges::rotate(t, std::ranges::min_element(t));
  std::ranges::sort(triangles);
}

}  // namespace

std::optional<std::vector<std::array<Index, 3>>> plane_triangulation(const RimPolygon& rims) {
  const RimPlane plane = plane_of_rim(std::span(rims.points).first(rims.loop_ends.front()));
  std::vector<Vec2> points;
  std::vector<std::array<Index, 2>> edges;
  for (Index point = 0; point < rims.points.size(); ++point) {
    points.push_back(plane.project(rims.points[point]));
    edges.push_back({point, rims.next(point)});
  }
  const PlanarTriangulationResult result = triangulate(points, edges);
  if (!result.conflict.empty() || result.triangulation.triangles.empty()) return std::nullopt;
  std::vector<std::array<Index, 3>> triangles = triangles_inside(result.triangulation);
  if (triangles.size() != expected_triangles(rims)) return std::nullopt;
  bring_in_order(triangles);
  return triangles;
}

}  // namespace croquis::hole_filling
