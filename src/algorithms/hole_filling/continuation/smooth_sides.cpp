// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/smooth_sides.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/crease_angle.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t least_triangles = 4;  // of a side: fewer aren't enough

class SideFinder {
 public:
  explicit SideFinder(const KnownSurface& known)
      : mesh_(known.mesh), distance_(known.distance), crease_cosine_(known.crease_cosine) {}

  std::vector<SmoothSide> run() {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto c = mesh_.face(f);
      normals_.push_back(
          (mesh_.positions[c[1]] - mesh_.positions[c[0]]).cross(mesh_.positions[c[2]] - mesh_.positions[c[0]]));
    }
    join_over_smooth_edges();
    std::vector<std::vector<Index>> triangles(mesh_.face_count());
    for (Index f = 0; f < mesh_.face_count(); ++f) triangles[sets_.root(f)].push_back(f);
    std::vector<SmoothSide> sides;
    for (const auto& part : triangles) {
      if (part.size() >= least_triangles && reaches_rim(part)) sides.push_back(side_of(part));
    }
    return sides;
  }

 private:
  void join_over_smooth_edges() {
    sets_ = DisjointSets(mesh_.face_count());
    std::vector<std::array<Index, 3>> edges;  // low, high, face
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const auto c = mesh_.face(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(c[i], c[(i + 1) % 3]);
        edges.push_back({low, high, f});
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const auto& [low, high, face] = edges[i];
      if (edges[i + 1][0] != low || edges[i + 1][1] != high) continue;
      if (is_smooth(normals_[face], normals_[edges[i + 1][2]], crease_cosine_)) sets_.unite(face, edges[i + 1][2]);
    }
  }

  bool reaches_rim(const std::vector<Index>& part) const {
    return std::any_of(part.begin(), part.end(), [&](Index f) {
      const auto c = mesh_.face(f);
      return std::count_if(c.begin(), c.end(), [&](Index v) { return distance_[v] == 0; }) >= 2;
    });
  }

  SmoothSide side_of(const std::vector<Index>& part) const {
    std::vector<std::pair<Index, Index>> uses;  // vertex, triangle
    for (const Index f : part) {
      for (const Index v : mesh_.face(f)) uses.emplace_back(v, f);
    }
    std::sort(uses.begin(), uses.end());
    SmoothSide side;
    for (std::size_t i = 0; i < uses.size();) {
      const Index v = uses[i].first;
      Vec3 sum = Vec3::Zero();
      for (; i < uses.size() && uses[i].first == v; ++i) sum += normals_[uses[i].second];
      if (!(sum.norm() > 0)) continue;
      side.vertices.push_back(v);
      side.normals.push_back(sum.normalized());
    }
    return side;
  }

  const PolyMesh& mesh_;
  const std::vector<double>& distance_;
  double crease_cosine_;
  std::vector<Vec3> normals_;  ///< per triangle, as long as twice its area
  DisjointSets sets_{0};
};

}  // namespace

std::vector<SmoothSide> smooth_sides(const KnownSurface& known) { return SideFinder(known).run(); }

}  // namespace croquis::hole_filling
