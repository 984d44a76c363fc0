// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_site.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

bool lies_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The vertex that is farthest from the rim's middle: however vertices are numbered, and however the mesh lies in
/// space, the same. Of several that are about as far, as on a circle, the one with the least coordinates.
std::vector<Index>::iterator first_of_rim(std::vector<Index>& rim, const std::vector<Vec3>& positions) {
  constexpr double about_as_far = 1 - 1e-9;  // of the squared distance
  Vec3 sum = Vec3::Zero();
  for (const Index v : rim) sum += positions[v] - positions[rim.front()];
  const Vec3 middle = positions[rim.front()] + sum / static_cast<double>(rim.size());
  const auto distance = [&](Index v) { return (positions[v] - middle).squaredNorm(); };
  double farthest = 0;
  for (const Index v : rim) farthest = std::max(farthest, distance(v));
  const auto lies_first = [&](Index a, Index b) {
    const bool a_is_far = distance(a) >= about_as_far * farthest, b_is_far = distance(b) >= about_as_far * farthest;
    return a_is_far != b_is_far ? a_is_far : a_is_far && lies_before(positions[a], positions[b]);
  };
  return std::min_element(rim.begin(), rim.end(), lies_first);
}

/// From the same vertex on, so that a rim gives the same patch however vertices are numbered.
void append_rim(const Hole& hole, HoleSite& site) {
  const std::vector<Vec3>& positions = site.mesh->positions;
  std::vector<Index> rim(hole.vertices.rbegin(), hole.vertices.rend());
  std::rotate(rim.begin(), first_of_rim(rim, positions), rim.end());
  for (const Index vertex : rim) {
    site.vertices.push_back(vertex);
    site.polygon.points.push_back(positions[vertex]);
  }
  site.polygon.loop_ends.push_back(static_cast<Index>(site.vertices.size()));
}

/// The edges between the site's own vertices, as pairs of points of its polygon.
void block_known_edges(HoleSite& site, std::span<const std::array<Index, 2>> rim_edges) {
  std::vector<std::pair<Index, Index>> by_vertex;  // vertex of the view, point
  for (Index point = 0; point < site.vertices.size(); ++point)
    by_vertex.emplace_back(site.analysis->view.representative_of(site.vertices[point]), point);
  std::sort(by_vertex.begin(), by_vertex.end());
  const auto points_of = [&](Index vertex) {
    return std::ranges::equal_range(by_vertex, vertex, {}, &std::pair<Index, Index>::first);
  };
  for (const auto& [vertex, point] : by_vertex) {
    for (const auto& edge : std::ranges::equal_range(rim_edges, vertex, {}, [](const auto& e) { return e[0]; })) {
      for (const auto& [other, other_point] : points_of(edge[1])) {
        const auto [low, high] = std::minmax({point, other_point});
        site.polygon.blocked.push_back({low, high});
      }
    }
  }
  std::sort(site.polygon.blocked.begin(), site.polygon.blocked.end());
}

void sort_unique(std::vector<Index>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

HoleSite make_site(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes,
                   std::span<const std::array<Index, 2>> rim_edges) {
  HoleSite site;
  site.mesh = &mesh;
  site.analysis = &analysis;
  site.holes.assign(holes.begin(), holes.end());
  std::vector<Index> order = site.holes;
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return analysis.holes[a].diameter > analysis.holes[b].diameter; });
  for (const Index id : order) append_rim(analysis.holes[id], site);
  block_known_edges(site, rim_edges);
  return site;
}

double rim_length(const HoleSite& site) {
  double length = 0;
  for (const Index id : site.holes) length += site.analysis->holes[id].perimeter;
  return length;
}

double mean_rim_edge(const HoleSite& site) {
  return rim_length(site) / static_cast<double>(std::max<std::size_t>(1, site.vertices.size()));
}

double widest_diameter(const HoleSite& site) {
  double widest = 0;
  for (const Index id : site.holes) widest = std::max(widest, site.analysis->holes[id].diameter);
  return widest;
}

std::vector<Vec3> normals_beyond(const HoleSite& site) {
  std::vector<std::array<Index, 3>> sides;  // of the faces: from, to, triangle; the polygon runs them backwards
  for (const Index id : site.holes) {
    const Hole& hole = site.analysis->holes[id];
    for (std::size_t i = 0; i < hole.vertices.size(); ++i)
      sides.push_back({hole.vertices[i], hole.vertices[(i + 1) % hole.vertices.size()], hole.corners[i] / 3});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Vec3> normals;
  for (Index point = 0; point < site.vertices.size(); ++point) {
    const std::array<Index, 3> side = {site.vertices[site.polygon.next(point)], site.vertices[point], 0};
    const Index triangle = (*std::lower_bound(sides.begin(), sides.end(), side))[2];
    const auto& [a, b, c] = site.analysis->view.triangles[triangle];
    const std::vector<Vec3>& at = site.mesh->positions;
    normals.push_back((at[b] - at[a]).cross(at[c] - at[a]).normalized());
  }
  return normals;
}

Vec3 triangle_normal(const HoleSite& site, Index triangle) {
  const auto& [a, b, c] = site.analysis->view.triangles[triangle];
  const std::vector<Vec3>& positions = site.mesh->positions;
  return (positions[b] - positions[a]).cross(positions[c] - positions[a]);
}

void add_fan(const SurfaceView& view, Index corner, std::vector<Index>& triangles) {
  const Index pivot = view.origin(corner);
  for (Index edge : {corner, SurfaceView::previous(corner)}) {
    while (view.has_opposite(edge) && view.opposite[edge] / 3 != corner / 3) {
      const Index other = view.opposite[edge];
      triangles.push_back(other / 3);
      edge = view.other_edge_at(other, pivot);
    }
  }
}

std::vector<Index> surroundings(const HoleSite& site, int rings) {
  const SurfaceView& view = site.analysis->view;
  std::vector<Index> triangles;
  for (const Index id : site.holes) {
    for (const Index corner : site.analysis->holes[id].corners) {
      triangles.push_back(corner / 3);
      add_fan(view, corner, triangles);
      add_fan(view, SurfaceView::next(corner), triangles);
    }
  }
  sort_unique(triangles);
  std::vector<Index> outer = triangles;  // what lies further in has its neighbours
  for (int ring = 1; ring < rings; ++ring) {
    std::vector<Index> around, next;
    for (const Index triangle : outer) {
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) add_fan(view, corner, around);
    }
    sort_unique(around);
    std::ranges::set_difference(around, triangles, std::back_inserter(next));
    const auto inner = std::ssize(triangles);
    triangles.insert(triangles.end(), next.begin(), next.end());
    std::inplace_merge(triangles.begin(), triangles.begin() + inner, triangles.end());
    outer = std::move(next);
  }
  return triangles;
}

}  // namespace croquis::hole_filling
