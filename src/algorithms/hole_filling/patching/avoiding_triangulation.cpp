// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/avoiding_triangulation.h"

#include <algorithm>
#include <utility>

#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "algorithms/hole_filling/triangulation/minimal_triangulation.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

constexpr std::size_t most_points = 300;

/// Searches: as many as cost about half a second, within these bounds. Where they came to something on known scans,
/// rims of 120 points and more took 8 at most, and no rim more than 100.
constexpr std::size_t least_searches = 25;
constexpr std::size_t most_searches = 300;
constexpr std::size_t search_cost = 100000000;  ///< sum of cubes of points

std::size_t searches_for(std::size_t points) {
  return std::clamp(search_cost / (points * points * points), least_searches, most_searches);
}

Eigen::AlignedBox3d reach_of(const RimPolygon& polygon) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : polygon.points) box.extend(point);
  return box;
}

double cost_of(const RimPolygon& polygon, const std::array<Index, 3>& t) {
  return triangle_cost(polygon.points[t[0]], polygon.points[t[1]], polygon.points[t[2]]);
}

/// Triangles to forbid: those that meet the surface, and of two that meet the costlier one. Each ascending.
Triangles offenders(const HoleSite& site, const NearScene& scene, const Triangles& triangulation, Progress& progress) {
  Triangles in_mesh = triangulation;
  for (auto& t : in_mesh) {
    for (Index& vertex : t) vertex = site.vertices[vertex];
  }
  Triangles found;
  for (const Clash& clash : scene.clashes({}, in_mesh, progress)) {
    const auto& later = triangulation[clash.triangle];
    const bool other_is_worse =
        clash.other != no_index && cost_of(site.polygon, triangulation[clash.other]) > cost_of(site.polygon, later);
    found.push_back(other_is_worse ? triangulation[clash.other] : later);
    std::sort(found.back().begin(), found.back().end());
  }
  return found;
}

std::optional<Triangles> search(const HoleSite& site, Progress& progress) {
  const std::size_t points = site.polygon.points.size();
  if (points <= 3 || points > most_points) return std::nullopt;  // a triangle has no other triangulation
  const NearScene scene(site, reach_of(site.polygon));
  RimPolygon polygon = site.polygon;
  MinimalTriangulations triangulations(polygon, bridged_order(polygon));
  for (std::size_t searches = searches_for(points); searches > 0; --searches) {
    progress.check();
    auto found = triangulations.next(progress);
    if (!found) return std::nullopt;
    const Triangles forbidden = offenders(site, scene, *found, progress);
    if (forbidden.empty()) return found;
    polygon.avoided.insert(polygon.avoided.end(), forbidden.begin(), forbidden.end());
    std::sort(polygon.avoided.begin(), polygon.avoided.end());
    polygon.avoided.erase(std::unique(polygon.avoided.begin(), polygon.avoided.end()), polygon.avoided.end());
  }
  return std::nullopt;
}

}  // namespace

std::optional<Triangles> avoiding_triangulation(const HoleSite& site, Progress& progress) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr) return search(site, progress);
  if (!memory->avoiding) memory->avoiding = search(site, progress);
  return *memory->avoiding;
}

}  // namespace croquis::hole_filling
