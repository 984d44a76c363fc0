// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/patch_confidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/patching/harmonic_values.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr double doubtful_jump = std::numbers::pi / 4;
constexpr double jump_accuracy = 1e-3;  // more than a colour shows

std::vector<Vec3> edge_middles(const HolePatch& patch, const PolyMesh& mesh) {
  std::vector<Vec3> middles;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      middles.push_back(0.5 * (mesh.positions[t[i]] + mesh.positions[t[(i + 1) % 3]]));
  }
  return middles;
}

/// What distances are measured from, and in what.
struct Rims {
  std::vector<Vec3> points;
  double size = 0;

  Rims(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
    for (const Index id : patch.holes) {
      for (const Index v : analysis.holes[id].vertices) points.push_back(mesh.positions[v]);
      size = std::max(size, analysis.holes[id].diameter);
    }
  }
};

/// Of a distance given in diameters.
double nearness(double distance) {
  const double twice = 2 * distance;
  return 1 / (1 + twice * twice * twice * twice);
}

Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

/// Per rim vertex of the patch the greatest angle across the rim's edges there.
class RimJumps {
 public:
  RimJumps(const HolePatch& patch, const PolyMesh& mesh, const SurfaceView& view, std::span<const Index> rim)
      : patch_(patch), mesh_(mesh), rim_(rim), jumps_(rim.size(), 0) {
    for (const auto& t : patch.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::max(t[i], t[(i + 1) % 3]) < mesh.vertex_count())
          sides_.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    view_ = &view;
  }

  std::vector<double> run(const HoleAnalysis& analysis) {
    for (const Index id : patch_.holes) {
      const Hole& hole = analysis.holes[id];
      for (std::size_t i = 0; i < hole.vertices.size(); ++i)
        look_across(hole.vertices[i], hole.vertices[(i + 1) % hole.vertices.size()], hole.corners[i]);
    }
    return jumps_;
  }

 private:
  const Vec3& at(Index v) const {
    const auto given = static_cast<Index>(mesh_.vertex_count());
    return v < given ? mesh_.positions[v] : patch_.points[v - given];
  }

  /// The patch runs along the edge from b to a.
  void look_across(Index a, Index b, Index corner) {
    const auto side = std::lower_bound(sides_.begin(), sides_.end(), std::array<Index, 3>{b, a, 0});
    if (side == sides_.end() || (*side)[0] != b || (*side)[1] != a) return;
    const auto& t = view_->triangles[corner / 3];
    const double jump = angle_between(normal_of(at(b), at(a), at((*side)[2])),
                                      normal_of(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]));
    for (const Index end : {a, b}) {
      const auto place = std::lower_bound(rim_.begin(), rim_.end(), end);
      if (place == rim_.end() || *place != end) continue;
      double& known = jumps_[static_cast<std::size_t>(place - rim_.begin())];
      known = std::max(known, jump);
    }
  }

  const HolePatch& patch_;
  const PolyMesh& mesh_;
  std::span<const Index> rim_;
  const SurfaceView* view_ = nullptr;
  std::vector<std::array<Index, 3>> sides_;  ///< of edges between rim vertices: from, to, the corner across; sorted
  std::vector<double> jumps_;
};

}  // namespace

double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  const Rims rims(patch, mesh, analysis);
  const implicit::PointTree tree(rims.points);
  double farthest = 0;
  for (const Vec3& place : patch.points.empty() ? edge_middles(patch, mesh) : patch.points)
    farthest = std::max(farthest, (place - rims.points[tree.nearest(place)]).norm());
  return nearness(farthest / rims.size);
}

std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  if (patch.points.empty()) return {};
  const Rims rims(patch, mesh, analysis);
  const implicit::PointTree tree(rims.points);
  const PatchGraph graph(patch, static_cast<Index>(mesh.vertex_count()));
  const std::vector<double> jumps =
      graph.harmonic(RimJumps(patch, mesh, analysis.view, graph.rim_vertices()).run(analysis), jump_accuracy);
  std::vector<float> confidence;
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    const Vec3& place = patch.points[i];
    const double distance = (place - rims.points[tree.nearest(place)]).norm() / rims.size;
    const double doubt = jumps[i] / doubtful_jump;
    confidence.push_back(static_cast<float>(nearness(distance) / (1 + doubt * doubt * doubt * doubt)));
  }
  return confidence;
}

}  // namespace croquis::hole_filling
