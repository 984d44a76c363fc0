// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/near_scene.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "algorithms/hole_filling/fairing/patch_editing.h"
#include "croquis/geometry/morton_order.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::hole_filling {
namespace {

/// More than can help to repair a patch.
constexpr std::size_t most_near_pairs = 100000;

/// So many queries without a tree cost about as much as making one.
constexpr std::size_t questions_before_tree = 8;

constexpr std::size_t fan = 8;  ///< boxes in one of the level above

/// Bits of three coordinates in turn, ten of each: near places mostly have near keys.
std::uint64_t morton_key(const Vec3& place, const Eigen::AlignedBox3d& bounds) {
  std::uint64_t key = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = bounds.sizes()[axis];
    const double share = size > 0 ? (place[axis] - bounds.min()[axis]) / size : 0;
    const auto cell = static_cast<std::uint32_t>(std::clamp(share * 1024, 0.0, 1023.0));
    key |= spread_by_three(cell) << axis;
  }
  return key;
}

std::vector<Eigen::AlignedBox3d> level_above(const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<Eigen::AlignedBox3d> above((boxes.size() + fan - 1) / fan);
  for (std::size_t i = 0; i < boxes.size(); ++i) above[i / fan].extend(boxes[i]);
  return above;
}

/// @param place of a vertex
template <typename Place>
Eigen::AlignedBox3d box_around(const std::array<Index, 3>& triangle, Place&& place) {
  Eigen::AlignedBox3d box;
  for (const Index vertex : triangle) box.extend(place(vertex));
  return box;
}

template <typename Place>
PolyMesh mesh_of(std::span<const std::array<Index, 3>> triangles, Place&& place) {
  const std::vector<Index> vertices = vertices_of(triangles);
  PolyMesh mesh;
  for (const Index vertex : vertices) mesh.positions.push_back(place(vertex));
  for (auto t : triangles) {
    for (Index& vertex : t)
      vertex = static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
    mesh.add_face(t);
  }
  return mesh;
}

}  // namespace

SurfaceSearch::Box SurfaceSearch::box_of(Index triangle) const {
  Box box;
  for (const Index vertex : view_.triangles[triangle]) box.extend(mesh_.positions[vertex]);
  return box;
}

std::vector<Index> SurfaceSearch::near(const Box& box) const {
  if (questions_++ < questions_before_tree) return near_by_looking_at_all(box);
  std::call_once(made_, [&] { make_tree(); });
  std::vector<Index> found;
  looked_at_ += descend(levels_.size() - 1, 0, box, found);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> SurfaceSearch::near_by_looking_at_all(const Box& box) const {
  std::vector<Index> found;
  for (Index t = 0; t < view_.triangles.size(); ++t) {
    if (box_of(t).intersects(box)) found.push_back(t);
  }
  looked_at_ += view_.triangles.size();
  return found;
}

void SurfaceSearch::make_tree() const {
  std::vector<Box> boxes;
  Box bounds;
  for (Index t = 0; t < view_.triangles.size(); ++t) {
    boxes.push_back(box_of(t));
    bounds.extend(boxes.back());
  }
  std::vector<std::uint64_t> keys;
  for (const Box& box : boxes) keys.push_back(morton_key(box.center(), bounds));
  order_ = radix_order(keys);
  std::vector<Box> ordered;
  for (const Index t : order_) ordered.push_back(boxes[t]);
  levels_.push_back(level_above(ordered));
  while (levels_.back().size() > 1) levels_.push_back(level_above(levels_.back()));
  looked_at_ += boxes.size();
}

std::size_t SurfaceSearch::descend(std::size_t level, std::size_t node, const Box& box,
                                   std::vector<Index>& found) const {
  if (!levels_[level][node].intersects(box)) return 1;
  std::size_t looked_at = 1;
  const std::size_t end = std::min((node + 1) * fan, level == 0 ? order_.size() : levels_[level - 1].size());
  for (std::size_t child = node * fan; child < end; ++child) {
    if (level > 0) {
      looked_at += descend(level - 1, child, box, found);
      continue;
    }
    ++looked_at;
    if (box_of(order_[child]).intersects(box)) found.push_back(order_[child]);
  }
  return looked_at;
}

std::vector<Index> triangles_near(const HoleSite& site, const SurfaceSearch::Box& box) {
  if (site.search != nullptr) return site.search->near(box);
  return SurfaceSearch(*site.mesh, site.analysis->view).near(box);
}

NearScene::NearScene(const HoleSite& site, const Eigen::AlignedBox3d& box)
    : view_(site.analysis->view), vertex_count_(static_cast<Index>(site.mesh->vertex_count())) {
  std::vector<std::array<Index, 3>> near;
  for (const Index t : triangles_near(site, box)) near.push_back(view_.triangles[t]);
  vertices_ = vertices_of(near);
  scene_ = mesh_of(near, [&](Index vertex) -> const Vec3& { return site.mesh->positions[vertex]; });
}

std::array<Index, 3> NearScene::in_scene(std::array<Index, 3> triangle) const {
  for (Index& vertex : triangle) {
    if (vertex >= vertex_count_) {
      vertex = static_cast<Index>(scene_.vertex_count()) + (vertex - vertex_count_);
      continue;
    }
    const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), view_.representative_of(vertex));
    vertex = static_cast<Index>(found - vertices_.begin());
  }
  return triangle;
}

std::vector<Clash> NearScene::clashes(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                                      Progress& progress) const {
  PolyMesh scene = scene_;
  const auto first = static_cast<Index>(scene.face_count());
  scene.positions.insert(scene.positions.end(), points.begin(), points.end());
  for (const auto& t : triangles) scene.add_face(in_scene(t));
  std::vector<Index> faces(triangles.size());
  std::iota(faces.begin(), faces.end(), first);
  Progress silent = progress.step("look for cuts", 0);
  std::vector<Clash> found;
  for (const auto& [low, high] : find_intersections_of(scene, faces, silent, {.max_pairs = most_near_pairs}).pairs)
    found.push_back({high - first, low < first ? no_index : low - first});
  return found;
}

std::size_t NearScene::count_clashes_of(std::span<const Index> chosen, std::span<const Vec3> points,
                                        std::span<const std::array<Index, 3>> triangles, Progress& progress) const {
  const auto first_point = static_cast<Index>(scene_.vertex_count());
  const auto place = [&](Index vertex) -> const Vec3& {
    return vertex < first_point ? scene_.positions[vertex] : points[vertex - first_point];
  };
  std::vector<std::array<Index, 3>> near;
  for (const Index t : chosen) near.push_back(in_scene(triangles[t]));
  Eigen::AlignedBox3d box;
  for (const auto& t : near) box.extend(box_around(t, place));
  const auto add_if_near = [&](const std::array<Index, 3>& t) {
    if (box_around(t, place).intersects(box)) near.push_back(t);
  };
  for (std::size_t c = 0; c < scene_.corners.size(); c += 3)
    add_if_near({scene_.corners[c], scene_.corners[c + 1], scene_.corners[c + 2]});
  for (Index t = 0; t < triangles.size(); ++t) {
    if (std::ranges::find(chosen, t) == chosen.end()) add_if_near(in_scene(triangles[t]));
  }
  std::vector<Index> faces(chosen.size());
  std::iota(faces.begin(), faces.end(), Index{0});
  Progress silent = progress.step("look for cuts", 0);
  return find_intersections_of(mesh_of(near, place), faces, silent, {.max_pairs = 0}).count;
}

}  // namespace croquis::hole_filling
