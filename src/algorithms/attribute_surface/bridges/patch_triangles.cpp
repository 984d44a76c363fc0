// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/patch_triangles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "croquis/geometry/planar_triangulation.h"

namespace croquis {
namespace {

constexpr double rim_gap = 0.6;       // × spacing: places inside keep so far from the outline
constexpr double bend = 1e-4;         // × side: sides are bent inwards, so that no triangle lies along one alone
constexpr double finest = 1.0 / 800;  // of the perimeter: rims of more edges don't make finer triangles inside
constexpr int most_passes = 20;
constexpr double least_gain_of_angle = 1e-9;

using Triangle = std::array<Index, 3>;
using Edge = std::array<Index, 2>;

std::vector<Vec2> places_inside(const DomainPolygon& domain, double spacing) {
  Vec2 low = domain.corners[0], high = low;
  for (const Vec2& corner : domain.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double row = spacing * std::sqrt(3.0) / 2;
  const auto rows = static_cast<int>((high - low).y() / row) + 1;
  const auto columns = static_cast<int>((high - low).x() / spacing) + 2;
  std::vector<Vec2> places;
  for (int j = -rows; j <= rows; ++j) {
    for (int i = -columns; i <= columns; ++i) {
      const double shift = j % 2 == 0 ? 0 : 0.5;
      const Vec2 place = domain.centroid + Vec2((i + shift) * spacing, j * row);
      if (distance_inside(domain, place) >= rim_gap * spacing) places.push_back(place);
    }
  }
  return places;
}

/// Which triangle has each directed edge.
std::map<Edge, std::size_t> edges_of(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::size_t> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) edges[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  }
  return edges;
}

Index third_corner(const Triangle& triangle, const Edge& edge) {
  for (const Index corner : triangle) {
    if (corner != edge[0] && corner != edge[1]) return corner;
  }
  return no_index;
}

class EdgeTurner {
 public:
  EdgeTurner(std::span<const Vec3> points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), edges_(edges_of(triangles)) {}

  void run() {
    bool changed = true;
    for (int pass = 0; changed && pass < most_passes; ++pass) {
      changed = false;
      std::vector<Edge> inner;
      for (const auto& [edge, triangle] : edges_) {
        if (edge[0] < edge[1] && edges_.contains({edge[1], edge[0]})) inner.push_back(edge);
      }
      for (const Edge& edge : inner) changed = turn(edge) || changed;
    }
  }

 private:
  Vec3 area(const Triangle& t) const { return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]); }

  /// The least angle, or less than any where the triangle is turned over.
  double quality(const Triangle& t, const Vec3& upwards) const {
    if (area(t).dot(upwards) <= 0) return -1;
    double least = 4;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& at = points_[t[i]];
      least = std::min(least, angle_between(points_[t[(i + 1) % 3]] - at, points_[t[(i + 2) % 3]] - at));
    }
    return least;
  }

  bool turn(const Edge& edge) {
    const auto left = edges_.find(edge), right = edges_.find({edge[1], edge[0]});
    if (left == edges_.end() || right == edges_.end()) return false;  // turned by now
    const std::size_t l = left->second, r = right->second;
    const Index c = third_corner(triangles_[l], edge), d = third_corner(triangles_[r], edge);
    if (edges_.contains({c, d}) || edges_.contains({d, c})) return false;
    const Triangle first{c, edge[0], d}, second{d, edge[1], c};
    const Vec3 upwards = area(triangles_[l]) + area(triangles_[r]);
    const double old_quality = std::min(quality(triangles_[l], upwards), quality(triangles_[r], upwards));
    const double new_quality = std::min(quality(first, upwards), quality(second, upwards));
    if (new_quality <= old_quality + least_gain_of_angle) return false;
    edges_.erase(edge);
    edges_.erase({edge[1], edge[0]});
    triangles_[l] = first;
    triangles_[r] = second;
    for (const std::size_t t : {l, r}) {
      for (std::size_t i = 0; i < 3; ++i) edges_[{triangles_[t][i], triangles_[t][(i + 1) % 3]}] = t;
    }
    return true;
  }

  std::span<const Vec3> points_;
  std::vector<Triangle>& triangles_;
  std::map<Edge, std::size_t> edges_;
};

/// One cut for a triangle at most.
bool cut_some_edges(const std::function<bool(Index, Index)>& is_taken, PatchTriangles& patch) {
  const auto edges = edges_of(patch.triangles);
  std::vector<bool> is_cut(patch.triangles.size(), false);
  for (const auto& [edge, left] : edges) {
    const auto right = edges.find({edge[1], edge[0]});
    if (edge[0] > edge[1] || right == edges.end() || !is_taken(edge[0], edge[1])) continue;
    if (is_cut[left] || is_cut[right->second]) continue;
    is_cut[left] = is_cut[right->second] = true;
    const auto middle = static_cast<Index>(patch.places.size());
    patch.places.push_back((patch.places[edge[0]] + patch.places[edge[1]]) / 2);
    for (const std::size_t t : {left, right->second}) {
      Triangle other = patch.triangles[t];
      std::ranges::replace(patch.triangles[t], edge[0], middle);
      std::ranges::replace(other, edge[1], middle);
      patch.triangles.push_back(other);
    }
  }
  return std::ranges::count(is_cut, true) > 0;
}

}  // namespace

PatchTriangles fill_domain(const DomainPolygon& domain, std::span<const OutlinePlace> outline, double spacing) {
  PatchTriangles patch;
  std::vector<Vec2> bent;
  std::vector<Edge> ring;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const OutlinePlace& at = outline[i];
    const Vec2 side = domain.corners[(at.side + 1) % domain.corners.size()] - domain.corners[at.side];
    patch.places.push_back(at.place);
    bent.push_back(at.place + 4 * bend * at.fraction * (1 - at.fraction) * left_of(side));
    ring.push_back({static_cast<Index>(i), static_cast<Index>((i + 1) % n)});
  }
  if (n > 3) {
    for (const Vec2& place : places_inside(domain, std::max(spacing, finest))) {
      patch.places.push_back(place);
      bent.push_back(place);
    }
  }
  const PlanarTriangulationResult plane = triangulate(bent, ring);
  if (plane.conflict.empty()) patch.triangles = triangles_inside(plane.triangulation);
  return patch;
}

void even_out(std::span<const Vec3> points, std::vector<Triangle>& triangles) { EdgeTurner(points, triangles).run(); }

void cut_edges(const std::function<bool(Index, Index)>& is_taken, PatchTriangles& patch) {
  while (cut_some_edges(is_taken, patch)) {
  }
}

}  // namespace croquis
