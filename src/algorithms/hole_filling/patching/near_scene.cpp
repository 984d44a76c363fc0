// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/near_scene.h"

#include <algorithm>
#include <numeric>

#include "croquis/geometry/self_intersection.h"

namespace croquis::hole_filling {
namespace {

/// More than can help to mend a patch.
constexpr std::size_t most_pairs = 100000;

}  // namespace

NearScene::NearScene(const PolyMesh& mesh, const SurfaceView& view, const Eigen::AlignedBox3d& box)
    : view_(view), vertex_count_(static_cast<Index>(mesh.vertex_count())) {
  std::vector<std::array<Index, 3>> near;
  for (const auto& t : view.triangles) {
    Eigen::AlignedBox3d bounds;
    for (const Index vertex : t) bounds.extend(mesh.positions[vertex]);
    if (bounds.intersects(box)) near.push_back(t);
  }
  for (const auto& t : near) vertices_.insert(vertices_.end(), t.begin(), t.end());
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  for (const Index vertex : vertices_) scene_.positions.push_back(mesh.positions[vertex]);
  for (auto& t : near) {
    for (Index& vertex : t) {
      const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
      vertex = static_cast<Index>(found - vertices_.begin());
    }
    scene_.add_face(t);
  }
}

std::vector<Clash> NearScene::clashes(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                                      Progress& progress) const {
  PolyMesh scene = scene_;
  const auto first_point = static_cast<Index>(scene.vertex_count());
  const auto first = static_cast<Index>(scene.face_count());
  scene.positions.insert(scene.positions.end(), points.begin(), points.end());
  for (auto t : triangles) {
    for (Index& vertex : t) {
      if (vertex >= vertex_count_) {
        vertex = first_point + (vertex - vertex_count_);
        continue;
      }
      const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), view_.representative_of(vertex));
      vertex = static_cast<Index>(found - vertices_.begin());
    }
    scene.add_face(t);
  }
  std::vector<Index> faces(triangles.size());
  std::iota(faces.begin(), faces.end(), first);
  Progress silent = progress.step("look for cuts", 0);
  std::vector<Clash> found;
  for (const auto& [low, high] : find_intersections_of(scene, faces, silent, {.max_pairs = most_pairs}).pairs)
    found.push_back({high - first, low < first ? no_index : low - first});
  return found;
}

}  // namespace croquis::hole_filling
