// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/near_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/hole_filling/fairing/fairing.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::hole_filling {
namespace {

/// More than can help to repair a patch.
constexpr std::size_t most_near_pairs = 100000;

/// So many queries without a tree cost about as much as making one.
constexpr std::size_t questions_before_tree = 8;

template <typename Place>
PolyMesh mesh_of(std::span<const Triangle> triangles, Place&& place) {
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

/// More than rounding makes of a determinant, × the product of its edges.
constexpr double rounding = 1e-14;

/// The side of the plane through a, b and c that d is on: 1, -1, or 0 where rounding might decide.
int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  const double volume = ab.cross(ac).dot(ad), doubt = rounding * ab.norm() * ac.norm() * ad.norm();
  return volume > doubt ? 1 : volume < -doubt ? -1 : 0;
}

/// Whether the line from p to q goes through the inside of the triangle.
bool goes_through(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (side_of(a, b, c, p) * side_of(a, b, c, q) >= 0) return false;
  const int turn = side_of(p, q, a, b);
  return turn != 0 && turn == side_of(p, q, b, c) && turn == side_of(p, q, c, a);
}

constexpr int most_trials = 300;

/// More pairs than this aren't a few triangles at a rough rim.
constexpr std::size_t most_clashes = 60;

/// Flips the edge that begins at a corner of a patch's triangle.
/// @param point of a vertex
/// @return the triangle on the other side of the edge, which is flipped as well; nothing where it can't be
template <typename Point>
std::optional<Index> flip_edge(std::vector<Triangle>& triangles, Index triangle, std::size_t side, const Point& point) {
  Triangle& t = triangles[triangle];
  const Index a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
  const auto has = [](const Triangle& u, Index v) { return std::ranges::find(u, v) != u.end(); };
  const auto has_area = [&](Index p, Index q, Index r) {
    return std::isfinite(triangle_cost(point(p), point(q), point(r)));
  };
  for (Index other = 0; other < triangles.size(); ++other) {
    Triangle& u = triangles[other];
    for (std::size_t i = 0; i < 3; ++i) {
      if (u[i] != b || u[(i + 1) % 3] != a) continue;
      const Index d = u[(i + 2) % 3];
      const bool are_joined = std::ranges::any_of(triangles, [&](const Triangle& v) { return has(v, c) && has(v, d); });
      if (c == d || are_joined || !has_area(a, d, c) || !has_area(b, c, d)) return std::nullopt;
      t = {a, d, c};
      u = {b, c, d};
      return other;
    }
  }
  return std::nullopt;  // on the rim
}

}  // namespace

std::vector<Index> SurfaceSearch::near(const Box& box) const {
  const auto count = static_cast<Index>(box_of_.view.triangles.size());
  std::vector<Index> found;
  if (questions_++ < questions_before_tree) {
    for (Index t = 0; t < count; ++t) {
      if (box_of_(t).intersects(box)) found.push_back(t);
    }
    looked_at_ += count;
    return found;
  }
  std::call_once(made_, [&] {
    tree_.emplace(count, box_of_);
    looked_at_ += count;
  });
  looked_at_ += tree_->visit(box, [&](Index t) { found.push_back(t); });
  std::ranges::sort(found);
  return found;
}

std::vector<Index> triangles_near(const HoleSite& site, const Box& box) {
  if (site.search != nullptr) return site.search->near(box);
  return SurfaceSearch(*site.mesh, site.analysis->view).near(box);
}

NearScene::NearScene(const HoleSite& site, const Box& box)
    : view_(site.analysis->view), vertex_count_(static_cast<Index>(site.mesh->vertex_count())) {
  std::vector<Triangle> near;
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

std::vector<Clash> NearScene::clashes(std::span<const Vec3> points, std::span<const Triangle> triangles,
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
                                        std::span<const Triangle> triangles, Progress& progress) const {
  const auto first_point = static_cast<Index>(scene_.vertex_count());
  const auto place = [&](Index vertex) -> const Vec3& {
    return vertex < first_point ? scene_.positions[vertex] : points[vertex - first_point];
  };
  std::vector<Triangle> near;
  for (const Index t : chosen) near.push_back(in_scene(triangles[t]));
  Box box;
  for (const Triangle& t : near) box.extend(box_of(t, place));
  const auto add_if_near = [&](const std::array<Index, 3>& t) {
    if (box_of(t, place).intersects(box)) near.push_back(t);
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

/// The surface is asked once for all rims: each question may look at all of a large mesh.
bool rims_cross_surface(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  const auto place = [&](Index vertex) -> const Vec3& { return site.mesh->positions[vertex]; };
  std::vector<std::array<Index, 2>> edges;
  for (Index point = 0; point < site.vertices.size(); ++point)
    edges.push_back({view.representative_of(site.vertices[point]),
                     view.representative_of(site.vertices[site.polygon.next(point)])});
  const BoxSearch search(edges.size(), [&](Index edge) { return box_of(edges[edge], place); });
  const Box around = box_of(edges, [&](const auto& edge) -> const Vec3& { return place(edge[0]); });
  return std::ranges::any_of(triangles_near(site, around), [&](Index triangle) {
    const Triangle& t = view.triangles[triangle];
    bool crosses = false;
    search.visit(box_of(t, place), [&](Index edge) {
      const Index from = edges[edge][0], to = edges[edge][1];
      const bool is_joined = std::ranges::any_of(t, [&](Index v) { return v == from || v == to; });
      crosses |= !is_joined && goes_through(place(from), place(to), place(t[0]), place(t[1]), place(t[2]));
    });
    return crosses;
  });
}

bool untangle(const HoleSite& site, HolePatch& patch, Progress& progress) {
  const auto given = static_cast<Index>(site.mesh->vertex_count());
  const auto point = [&](Index vertex) -> const Vec3& {
    return vertex < given ? site.mesh->positions[vertex] : patch.points[vertex - given];
  };
  Box reach;
  for (const Triangle& t : patch.triangles) reach.extend(box_of(t, point));
  const NearScene scene(site, reach);
  std::vector<Clash> clashes = scene.clashes(patch.points, patch.triangles, progress);
  int trials = 0;
  // The first flip of an edge of a clashing triangle that leaves fewer clashes.
  const auto improve = [&] {
    for (const Clash& clash : clashes) {
      for (const Index triangle : {clash.triangle, clash.other}) {
        for (std::size_t side = 0; side < 3 && triangle != no_index; ++side) {
          if (++trials > most_trials) return false;
          const std::vector<Triangle> before = patch.triangles;
          const auto other = flip_edge(patch.triangles, triangle, side, point);
          if (!other) continue;
          const std::array flipped = {triangle, *other};
          const auto of_flipped = std::ranges::count_if(clashes, [&](const Clash& known) {
            return std::ranges::find(flipped, known.triangle) != flipped.end() ||
                   std::ranges::find(flipped, known.other) != flipped.end();
          });
          if (scene.count_clashes_of(flipped, patch.points, patch.triangles, progress) <
              static_cast<std::size_t>(of_flipped))
            return true;
          patch.triangles = before;
        }
      }
    }
    return false;
  };
  while (!clashes.empty() && clashes.size() <= most_clashes && improve())
    clashes = scene.clashes(patch.points, patch.triangles, progress);
  return clashes.empty();
}

}  // namespace croquis::hole_filling
