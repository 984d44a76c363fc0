// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/avoiding_triangulation.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/triangle_cost.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::hole_filling {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

constexpr std::size_t most_points = 300;

/// Searches: as many as cost about half a second, within these bounds.
constexpr std::size_t least_searches = 40;
constexpr std::size_t most_searches = 1000;
constexpr std::size_t search_cost = 100000000;  ///< sum of cubes of points

std::size_t searches_for(std::size_t points) {
  return std::clamp(search_cost / (points * points * points), least_searches, most_searches);
}

/// The triangles of the view whose boxes meet the rim's, then, in its turn, a triangulation of the rim.
class NearScene {
 public:
  explicit NearScene(const HoleSite& site) : site_(site) {
    Eigen::AlignedBox3d reach;
    for (const Vec3& point : site.polygon.points) reach.extend(point);
    Triangles near;
    for (const auto& t : site.analysis->view.triangles) {
      Eigen::AlignedBox3d box;
      for (const Index vertex : t) box.extend(site.mesh->positions[vertex]);
      if (box.intersects(reach)) near.push_back(t);
    }
    for (const auto& t : near) vertices_.insert(vertices_.end(), t.begin(), t.end());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const Index vertex : vertices_) scene_.positions.push_back(site.mesh->positions[vertex]);
    for (const auto& t : near) scene_.add_face(std::array{number(t[0]), number(t[1]), number(t[2])});
  }

  /// Triangles of the triangulation to forbid: those that meet the surface, and of two that meet the costlier one.
  Triangles offenders(const Triangles& triangulation, Progress& progress) {
    PolyMesh scene = scene_;
    for (const auto& t : triangulation) scene.add_face(std::array{of_point(t[0]), of_point(t[1]), of_point(t[2])});
    const auto first = static_cast<Index>(scene_.face_count());
    std::vector<Index> faces(triangulation.size());
    std::iota(faces.begin(), faces.end(), first);
    Triangles found;
    for (const auto& [low, high] : find_intersections_of(scene, faces, progress, {.max_pairs = 100000}).pairs) {
      const auto& later = triangulation[high - first];
      const bool earlier_is_worse = low >= first && cost(triangulation[low - first]) > cost(later);
      found.push_back(earlier_is_worse ? triangulation[low - first] : later);
      std::sort(found.back().begin(), found.back().end());
    }
    return found;
  }

 private:
  Index number(Index vertex) const {
    return static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin());
  }
  Index of_point(Index point) const { return number(site_.analysis->view.representative_of(site_.vertices[point])); }

  double cost(const std::array<Index, 3>& t) const {
    const auto& points = site_.polygon.points;
    return triangle_cost(points[t[0]], points[t[1]], points[t[2]]);
  }

  const HoleSite& site_;
  std::vector<Index> vertices_;  ///< of the view, sorted, per vertex of the scene
  PolyMesh scene_;
};

}  // namespace

std::optional<Triangles> avoiding_triangulation(const HoleSite& site, Progress& progress) {
  if (site.polygon.points.size() > most_points) return std::nullopt;
  NearScene scene(site);
  RimPolygon polygon = site.polygon;
  for (std::size_t searches = searches_for(polygon.points.size()); searches > 0; --searches) {
    progress.check();
    auto found = triangulate_rim(polygon, progress, {.exact_points = most_points});
    if (!found) return std::nullopt;
    const Triangles offenders = scene.offenders(found->triangles, progress);
    if (offenders.empty()) return std::move(found->triangles);
    polygon.avoided.insert(polygon.avoided.end(), offenders.begin(), offenders.end());
    std::sort(polygon.avoided.begin(), polygon.avoided.end());
    polygon.avoided.erase(std::unique(polygon.avoided.begin(), polygon.avoided.end()), polygon.avoided.end());
  }
  return std::nullopt;
}

}  // namespace croquis::hole_filling
