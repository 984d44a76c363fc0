// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "algorithms/perspective/faces/plane_faces.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

/// Edges that meet at less than this angle (radians) span no plane.
constexpr double least_corner_angle = 0.035;

/// A curve spans a plane if the area between it and its chord is at least that much of the chord's square …
constexpr double least_bulge = 0.01;

/// … and it is no farther from the plane than that, × diagonal.
constexpr double flat_curve = 1e-6;

/// The curve's coordinate along an axis if it is the same everywhere.
const double* level_along(const NetworkCurve& curve, int axis) {
  const double* level = &curve.pieces.front().points[0][axis];
  if (curve.straight) return curve.pieces.back().points[3][axis] == *level ? level : nullptr;
  for (const RationalCubic& piece : curve.pieces) {
    for (const Vec3& p : piece.points) {
      if (p[axis] != *level) return nullptr;
    }
  }
  return level;
}

std::vector<EdgePlane> axis_planes(const CurveNetwork& network, const SolidGraph& graph) {
  std::vector<EdgePlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    std::map<double, std::vector<Index>> levels;
    for (Index e = 0; e < graph.edges.size(); ++e) {
      const double* level = level_along(network.curves[graph.edges[e].curve], axis);
      if (level != nullptr) levels[*level].push_back(e);
    }
    for (auto& [level, edges] : levels) {
      if (edges.size() > 1 || graph.edges[edges[0]].start == graph.edges[edges[0]].end) {
        planes.push_back({level * Vec3::Unit(axis), Vec3::Unit(axis), axis, std::move(edges)});
      }
    }
  }
  return planes;
}

bool lies_in(const GraphEdge& edge, const Vec3& origin, const Vec3& normal, double tolerance) {
  return std::ranges::all_of(edge.samples,
                             [&](const Vec3& p) { return std::abs(normal.dot(p - origin)) <= tolerance; });
}

class ObliquePlanes {
 public:
  ObliquePlanes(const SolidGraph& graph, std::vector<EdgePlane>& planes, double tolerance)
      : graph_(graph), planes_(planes), tolerance_(tolerance), planes_at_(graph.edges.size()) {
    for (Index p = 0; p < planes.size(); ++p) enter(p);
  }

  void run() {
    for (Index e = 0; e < graph_.edges.size(); ++e) try_curve(e);
    for (const std::vector<Index>& halves : graph_.outgoing) {
      for (std::size_t i = 0; i < halves.size(); ++i) {
        for (std::size_t j = i + 1; j < halves.size(); ++j) try_pair(halves[i], halves[j]);
      }
    }
  }

 private:
  void enter(Index plane) {
    for (const Index e : planes_[plane].edges) planes_at_[e].push_back(plane);
  }

  /// A curve that bends lies in one plane at most.
  void try_curve(Index e) {
    const GraphEdge& edge = graph_.edges[e];
    if (edge.straight || !planes_at_[e].empty()) return;
    const Vec3 normal = area_normal(edge.samples);
    if (normal.norm() < least_bulge * (edge.samples.back() - edge.samples.front()).squaredNorm()) return;
    if (lies_in(edge, edge.samples[0], normal.normalized(), flat_curve * graph_.size)) {
      add(edge.samples[0], normal.normalized());
    }
  }

  void try_pair(Index a, Index b) {
    if (!graph_.edges[a / 2].straight || !graph_.edges[b / 2].straight) return;
    const Vec3 origin = graph_.points[graph_.origin(a)];
    const Vec3 to_a = (graph_.points[graph_.target(a)] - origin).normalized();
    const Vec3 to_b = (graph_.points[graph_.target(b)] - origin).normalized();
    const Vec3 normal = to_a.cross(to_b);
    if (normal.norm() < least_corner_angle || share_plane(a / 2, b / 2)) return;
    add(origin, normal.normalized());
  }

  void add(const Vec3& origin, const Vec3& normal) {
    EdgePlane plane{origin, normal, -1, {}};
    for (Index e = 0; e < graph_.edges.size(); ++e) {
      if (lies_in(graph_.edges[e], origin, plane.normal, tolerance_)) plane.edges.push_back(e);
    }
    if (plane.edges.size() < 2 || !known_.insert(plane.edges).second || within_known(plane.edges)) return;
    planes_.push_back(std::move(plane));
    enter(static_cast<Index>(planes_.size() - 1));
  }

  bool share_plane(Index a, Index b) const {
    return std::ranges::any_of(planes_at_[a], [&](Index p) { return std::ranges::count(planes_at_[b], p) > 0; });
  }

  bool within_known(const std::vector<Index>& edges) const {
    return std::ranges::any_of(planes_at_[edges[0]],
                               [&](Index p) { return std::ranges::includes(planes_[p].edges, edges); });
  }

  const SolidGraph& graph_;
  std::vector<EdgePlane>& planes_;
  double tolerance_;
  std::vector<std::vector<Index>> planes_at_;
  std::set<std::vector<Index>> known_;
};

}  // namespace

std::vector<EdgePlane> planes_of(const CurveNetwork& network, const SolidGraph& graph, double tolerance) {
  std::vector<EdgePlane> planes = axis_planes(network, graph);
  ObliquePlanes(graph, planes, tolerance).run();
  return planes;
}

}  // namespace croquis
