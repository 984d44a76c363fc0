// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/plane_triangulation.h"

#include <cstdint>
#include <span>

#include "algorithms/hole_filling/triangulation/rim_plane.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis::hole_filling {
namespace {

constexpr std::uint8_t unknown = 2;

/// Spreads from the hull: crossing a rim changes sides.
std::vector<std::uint8_t> inside_of_rims(const PlanarTriangulation& plane) {
  std::vector<std::uint8_t> inside(plane.triangles.size(), unknown);
  std::vector<Index> pending;
  for (Index t = 0; t < plane.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3 && inside[t] == unknown; ++i) {
      if (plane.neighbours[t][i] != no_index) continue;
      inside[t] = plane.constraints[t][i] != no_index ? 1 : 0;
      pending.push_back(t);
    }
  }
  while (!pending.empty()) {
    const Index t = pending.back();
    pending.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index other = plane.neighbours[t][i];
      if (other == no_index || inside[other] != unknown) continue;
      const bool crosses = plane.constraints[t][i] != no_index;
      inside[other] = static_cast<std::uint8_t>(crosses != (inside[t] != 0));
      pending.push_back(other);
    }
  }
  return inside;
}

/// A triangulation of all points whose rims run with the patch on their left has 2 (loops - 1) - 2 + points triangles.
std::size_t expected_triangles(const RimPolygon& rims) { return rims.points.size() + 2 * rims.loop_count() - 4; }

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
  const std::vector<std::uint8_t> inside = inside_of_rims(result.triangulation);
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] == 1) triangles.push_back(result.triangulation.triangles[t]);
  }
  if (triangles.size() != expected_triangles(rims)) return std::nullopt;
  return triangles;
}

}  // namespace croquis::hole_filling
