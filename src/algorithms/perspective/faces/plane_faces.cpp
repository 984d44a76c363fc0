// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/plane_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "algorithms/perspective/solid/plane_axes.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

constexpr double outline_cost = 0.02;
constexpr double holes_gain = 0.01;
constexpr double oblique_cost = 0.05;

/// Curves are ordered around a vertex where they leave a circle of this radius, × the shortest one's extent: there
/// curves that start in the same direction have parted.
constexpr double parting_radius = 0.25;

struct TracedLoop {
  std::vector<Index> halves;
  std::vector<Vec2> outline;
  double area = 0;  ///< positive: around a bounded region; negative: around a connected part, seen from outside
};

/// The drawing that edges make in a plane, walked around.
class PlaneArrangement {
 public:
  PlaneArrangement(const SolidGraph& graph, const EdgePlane& plane) : graph_(graph), plane_(plane) {
    const Vec3 helper = Vec3::Unit(plane.axis >= 0 ? (plane.axis + 1) % 3 : least_axis(plane.normal));
    u_ = plane.axis >= 0 ? helper : Vec3((helper - plane.normal.dot(helper) * plane.normal).normalized());
    v_ = plane.normal.cross(u_);
    edges_.assign(plane.edges.begin(), plane.edges.end());
  }

  /// Loops of edges that have different loops on both sides.
  std::vector<TracedLoop> trace() {
    while (!edges_.empty()) {
      sort_around_vertices();
      std::vector<TracedLoop> loops = walk();
      if (!drop_one_sided(loops)) return loops;
    }
    return {};
  }

  Vec2 flat(const Vec3& p) const { return {u_.dot(p - plane_.origin), v_.dot(p - plane_.origin)}; }

 private:
  static int least_axis(const Vec3& normal) {
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    return axis;
  }

  /// The direction in which a half-edge leaves the circle around its vertex.
  double angle_at(Index half, double radius) const {
    const GraphEdge& edge = graph_.edges[half / 2];
    const std::size_t last = edge.samples.size() - 1;
    const auto sample = [&](std::size_t i) {
      return flat((half & 1U) != 0 ? edge.samples[last - i] : edge.samples[i]);
    };
    const Vec2 origin = sample(0);
    for (std::size_t i = 1; i <= last; ++i) {
      const Vec2 outer = sample(i) - origin;
      if (outer.norm() < radius && i < last) continue;
      const Vec2 inner = sample(i - 1) - origin;
      const double from = inner.norm(), to = outer.norm();
      const Vec2 at = inner + (outer - inner) * (to > from ? std::clamp((radius - from) / (to - from), 0.0, 1.0) : 1);
      return std::atan2(at.y(), at.x());
    }
    return 0;
  }

  double extent(Index half) const {
    double greatest = 0;
    const Vec3& origin = graph_.points[graph_.origin(half)];
    for (const Vec3& p : graph_.edges[half / 2].samples) greatest = std::max(greatest, (p - origin).norm());
    return greatest;
  }

  void sort_around_vertices() {
    around_.clear();
    for (const Index e : edges_) {
      for (const Index half : {2 * e, 2 * e + 1}) around_[graph_.origin(half)].push_back(half);
    }
    for (auto& [vertex, halves] : around_) {
      double radius = extent(halves[0]);
      for (const Index half : halves) radius = std::min(radius, extent(half));
      std::map<Index, double> angle;
      for (const Index half : halves) angle[half] = angle_at(half, parting_radius * radius);
      std::ranges::sort(halves, {}, [&](Index half) { return std::pair(angle[half], half); });
    }
  }

  /// The next half-edge around the region on the left.
  Index next(Index half) const {
    const std::vector<Index>& halves = around_.at(graph_.target(half));
    const auto back = std::ranges::find(halves, SolidGraph::twin(half));
    return back == halves.begin() ? halves.back() : *(back - 1);
  }

  std::vector<TracedLoop> walk() const {
    std::vector<TracedLoop> loops;
    std::set<Index> seen;
    for (const Index e : edges_) {
      for (const Index first : {2 * e, 2 * e + 1}) {
        if (!seen.insert(first).second) continue;
        TracedLoop loop;
        loop.halves.push_back(first);
        for (Index half = next(first); half != first; half = next(half)) {
          seen.insert(half);
          loop.halves.push_back(half);
        }
        for (const Index half : loop.halves) {
          graph_.visit_samples(half, 1, [&](const Vec3& p) { loop.outline.push_back(flat(p)); });
        }
        for (std::size_t i = 0, j = loop.outline.size() - 1; i < loop.outline.size(); j = i++) {
          loop.area += cross(loop.outline[j], loop.outline[i]) / 2;
        }
        loops.push_back(std::move(loop));
      }
    }
    return loops;
  }

  bool drop_one_sided(const std::vector<TracedLoop>& loops) {
    const std::size_t before = edges_.size();
    for (const TracedLoop& loop : loops) {
      const std::set<Index> halves(loop.halves.begin(), loop.halves.end());
      for (const Index half : loop.halves) {
        if (halves.contains(SolidGraph::twin(half))) std::erase(edges_, half / 2);
      }
    }
    return edges_.size() != before;
  }

  const SolidGraph& graph_;
  const EdgePlane& plane_;
  Vec3 u_, v_;
  std::vector<Index> edges_;
  std::map<Index, std::vector<Index>> around_;
};

/// A closed walk cut where it comes to a vertex again.
std::vector<std::vector<Index>> simple_loops(const SolidGraph& graph, const std::vector<Index>& walk) {
  std::vector<std::vector<Index>> loops;
  std::vector<Index> path;
  for (const Index half : walk) {
    path.push_back(half);
    const Index target = graph.target(half);
    const auto begin = std::ranges::find(path, target, [&](Index h) { return graph.origin(h); });
    if (begin == path.end()) continue;
    loops.emplace_back(begin, path.end());
    path.erase(begin, path.end());
  }
  return loops;
}

/// Turns loops that were walked around into candidates.
class PlaneCandidates {
 public:
  PlaneCandidates(const SolidGraph& graph, const EdgePlane& plane, Index number, std::vector<TracedLoop> loops)
      : graph_(graph), plane_(plane), number_(number), loops_(std::move(loops)), parent_(loops_.size(), no_index) {
    for (Index i = 0; i < loops_.size(); ++i) {
      if (loops_[i].area < 0) parent_[i] = region_around(loops_[i]);
    }
    find_parts();
  }

  std::vector<FaceCandidate> run() {
    for (Index r = 0; r < loops_.size(); ++r) {
      if (loops_[r].area > 0) add_region(r);
    }
    for (Index i = 0; i < loops_.size(); ++i) {
      if (loops_[i].area < 0) add_outlines(i);
    }
    return std::move(candidates_);
  }

 private:
  /// The smallest region of another part that has the part inside.
  Index region_around(const TracedLoop& part) const {
    Index found = no_index;
    const std::set<Index> own = vertices_of(part.halves);
    for (Index r = 0; r < loops_.size(); ++r) {
      if (loops_[r].area <= -part.area || (found != no_index && loops_[r].area >= loops_[found].area)) continue;
      if (own.contains(graph_.origin(loops_[r].halves[0]))) continue;
      if (encloses(loops_[r].outline, part.outline[0])) found = r;
    }
    return found;
  }

  std::set<Index> vertices_of(const std::vector<Index>& halves) const {
    std::set<Index> vertices;
    for (const Index half : halves) vertices.insert(graph_.origin(half));
    return vertices;
  }

  /// Regions belong to the part whose outline they are connected with, by walking over shared edges.
  void find_parts() {
    std::map<Index, Index> loop_of;
    for (Index i = 0; i < loops_.size(); ++i) {
      for (const Index half : loops_[i].halves) loop_of[half] = i;
    }
    part_.assign(loops_.size(), no_index);
    for (Index i = 0; i < loops_.size(); ++i) {
      if (loops_[i].area >= 0) continue;
      std::vector<Index> pending = {i};
      while (!pending.empty()) {
        const Index l = pending.back();
        pending.pop_back();
        if (part_[l] != no_index) continue;
        part_[l] = i;
        for (const Index half : loops_[l].halves) pending.push_back(loop_of[SolidGraph::twin(half)]);
      }
    }
  }

  /// Regions inside the part with that outline, and in its holes.
  void collect_regions(Index outline, std::vector<Index>& regions) const {
    for (Index r = 0; r < loops_.size(); ++r) {
      if (loops_[r].area > 0 && part_[r] == outline) collect_region(r, regions);
    }
  }

  void collect_region(Index region, std::vector<Index>& regions) const {
    regions.push_back(region);
    for (Index i = 0; i < loops_.size(); ++i) {
      if (parent_[i] == region) collect_regions(i, regions);
    }
  }

  void add(std::vector<std::vector<Index>> loops, std::vector<Index> regions, double cost) {
    FaceCandidate face;
    for (const auto& loop : loops) {
      for (const Index half : loop) face.edges.push_back(half / 2);
    }
    std::ranges::sort(face.edges);
    std::ranges::sort(regions);
    face.loops = std::move(loops);
    face.origin = plane_.origin;
    face.normal = plane_.normal;
    face.cost = cost + (plane_.axis < 0 ? oblique_cost : 0);
    face.plane = number_;
    face.regions = std::move(regions);
    if (plane_.axis < 0) fit_plane(face);
    candidates_.push_back(std::move(face));
  }

  /// An oblique plane was found from two edges; the face's own is the one of its whole outline.
  void fit_plane(FaceCandidate& face) const {
    const std::vector<Vec3> outline = graph_.polygon(face.loops[0]);
    const Vec3 normal = area_normal(outline);
    face.origin = Vec3::Zero();
    for (const Vec3& p : outline) face.origin += p / static_cast<double>(outline.size());
    if (normal.norm() > 0) face.normal = normal.normalized();
    for (const auto& loop : face.loops) {
      for (const Vec3& p : graph_.polygon(loop)) {
        face.flatness = std::max(face.flatness, std::abs(face.normal.dot(p - face.origin)));
      }
    }
    face.deviation = face.flatness / std::sqrt(std::max(normal.norm(), 1e-300));
  }

  void add_region(Index region) {
    std::vector<std::vector<Index>> loops = {loops_[region].halves};
    for (Index i = 0; i < loops_.size(); ++i) {
      if (parent_[i] == region) loops.push_back(loops_[i].halves);
    }
    if (loops.size() > 1) add(loops, {region}, -holes_gain);
    std::vector<Index> regions;
    collect_region(region, regions);
    add({loops_[region].halves}, std::move(regions), 0);
  }

  void add_outlines(Index outline) {
    for (const std::vector<Index>& loop : simple_loops(graph_, loops_[outline].halves)) {
      std::vector<Index> regions;
      collect_regions(outline, regions);
      if (loop.size() != loops_[outline].halves.size()) keep_inside(loop, regions);
      if (regions.size() > 1) add({SolidGraph::turned(loop)}, std::move(regions), outline_cost);
    }
  }

  void keep_inside(const std::vector<Index>& loop, std::vector<Index>& regions) const {
    const std::set<Index> edges = [&] {
      std::set<Index> result;
      for (const Index half : loop) result.insert(half / 2);
      return result;
    }();
    const std::set<Index> corners = vertices_of(loop);
    std::erase_if(regions, [&](Index r) {
      const std::vector<Index>& halves = loops_[r].halves;
      return std::ranges::none_of(halves, [&](Index h) { return edges.contains(h / 2); }) &&
             std::ranges::none_of(halves, [&](Index h) { return corners.contains(graph_.origin(h)); });
    });
  }

  const SolidGraph& graph_;
  const EdgePlane& plane_;
  Index number_;
  std::vector<TracedLoop> loops_;
  std::vector<Index> parent_;  ///< of outlines: the region around them
  std::vector<Index> part_;    ///< of loops: the outline of their part
  std::vector<FaceCandidate> candidates_;
};

/// Edges that meet at less than this angle (radians) span no plane.
constexpr double least_corner_angle = 0.035;

/// A curve spans a plane if the area between it and its chord is at least that much of the chord's square …
constexpr double least_bulge = 0.01;

/// … and it is no farther from the plane than that, × diagonal.
constexpr double flat_curve = 1e-6;

/// The curve's coordinate along an axis if it is the same everywhere.
const double* level_along(const NetworkCurve& curve, int axis) {
  if (!curve.straight) return common_level(curve.pieces, axis);
  const double& level = curve.pieces.front().points[0][axis];
  return curve.pieces.back().points[3][axis] == level ? &level : nullptr;
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

std::vector<FaceCandidate> faces_in_plane(const SolidGraph& graph, const EdgePlane& plane, Index number) {
  PlaneArrangement arrangement(graph, plane);
  return PlaneCandidates(graph, plane, number, arrangement.trace()).run();
}

std::vector<EdgePlane> planes_of(const CurveNetwork& network, const SolidGraph& graph, double tolerance) {
  std::vector<EdgePlane> planes = axis_planes(network, graph);
  ObliquePlanes(graph, planes, tolerance).run();
  return planes;
}

}  // namespace croquis
