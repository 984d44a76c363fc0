// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/free_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/predicates.h"

namespace croquis {
namespace {

constexpr double free_cost = 0.2;
constexpr double deviation_cost = 3;
constexpr double chord_cost = 0.5;
constexpr double free_side_cost = 0.02;
constexpr double all_straight_cost = 1;

/// Dearer loops aren't candidates: leaving their sides open would hardly be worse.
constexpr double greatest_free_cost = 4;

/// Loops looked at in one search; a network of 400 curves has some thousands of up to 8 sides.
constexpr std::size_t most_loops = 50000;

/// Every how many samples of a curve the polygon has that is checked for crossings.
constexpr std::size_t crossing_step = 4;

/// A loop this close to its mean plane is a flat face after all (× diagonal).
constexpr double flat_loop = 1e-7;

bool crosses_itself(const std::vector<Vec3>& polygon, const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vec2> flat;
  for (const Vec3& p : polygon) flat.emplace_back(u.dot(p), v.dot(p));
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (segments_cross(flat[i], flat[i + 1], flat[j], flat[(j + 1) % n])) return true;
    }
  }
  return false;
}

class LoopSearch {
 public:
  LoopSearch(const SolidGraph& graph, const std::vector<EdgePlane>& planes, const FreeFaceSearch& search)
      : graph_(graph),
        kind_(search.kind),
        max_sides_(search.max_sides),
        planes_at_(graph.edges.size()),
        on_path_(graph.points.size(), 0),
        allowed_(graph.edges.size(), 1) {
    if (search.usable != nullptr) allowed_ = *search.usable;
    for (Index p = 0; p < planes.size(); ++p) {
      for (const Index e : planes[p].edges) planes_at_[e].push_back(p);
    }
    for (Index e = 0; e < graph.edges.size(); ++e) {
      if (kind_ == FreeFaceKind::AllStraight && !graph.edges[e].straight) allowed_[e] = 0;
    }
  }

  FreeFaces run(Progress& progress) {
    for (Index e = 0; e < graph_.edges.size() && !result_.cut_short; ++e) {
      progress.check();
      const GraphEdge& edge = graph_.edges[e];
      if (allowed_[e] == 0 || edge.straight != (kind_ == FreeFaceKind::AllStraight)) continue;
      allowed_[e] = 0;  // loops through this edge are found now, all of them
      if (edge.start == edge.end) continue;
      measure_steps(edge.start);
      path_ = {2 * e};
      on_path_[edge.start] = on_path_[edge.end] = 1;
      extend(edge.end, edge.start);
      on_path_[edge.start] = on_path_[edge.end] = 0;
    }
    return std::move(result_);
  }

 private:
  /// How many allowed edges lead from each vertex to the goal, at least.
  void measure_steps(Index goal) {
    steps_.assign(graph_.points.size(), no_index);
    steps_[goal] = 0;
    std::vector<Index> pending = {goal};
    for (std::size_t i = 0; i < pending.size(); ++i) {
      for (const Index half : graph_.outgoing[pending[i]]) {
        const Index v = graph_.target(half);
        if (allowed_[half / 2] == 0 || steps_[v] != no_index) continue;
        steps_[v] = steps_[pending[i]] + 1;
        if (steps_[v] + 1 < max_sides_) pending.push_back(v);
      }
    }
  }

  void extend(Index at, Index goal) {
    for (const Index half : graph_.outgoing[at]) {
      if (allowed_[half / 2] == 0 || result_.cut_short) continue;
      const Index v = graph_.target(half);
      if (v == goal) {
        path_.push_back(half);
        take();
        path_.pop_back();
        continue;
      }
      if (on_path_[v] != 0 || steps_[v] == no_index || path_.size() + 1 + steps_[v] > max_sides_) continue;
      path_.push_back(half);
      on_path_[v] = 1;
      extend(v, goal);
      on_path_[v] = 0;
      path_.pop_back();
    }
  }

  bool in_known_plane() const {
    return std::ranges::any_of(planes_at_[path_[0] / 2], [&](Index p) {
      return std::ranges::all_of(path_, [&](Index h) { return std::ranges::count(planes_at_[h / 2], p) > 0; });
    });
  }

  /// Other edges between vertices of the path.
  std::size_t chords() {
    std::size_t count = 0;
    for (const Index on : path_) {
      for (const Index half : graph_.outgoing[graph_.origin(on)]) {
        const bool own = std::ranges::any_of(path_, [&](Index h) { return h / 2 == half / 2; });
        if ((half & 1U) == 0 && !own && on_loop(graph_.target(half))) ++count;
      }
    }
    return count;
  }

  bool on_loop(Index vertex) const { return on_path_[vertex] != 0; }

  void take() {
    if (++looked_at_ > most_loops) {
      result_.cut_short = true;
      return;
    }
    if (in_known_plane()) return;
    FaceCandidate face;
    face.cost =
        free_cost + free_side_cost * static_cast<double>(path_.size()) + chord_cost * static_cast<double>(chords());
    if (kind_ == FreeFaceKind::AllStraight) face.cost += all_straight_cost;
    if (face.cost > greatest_free_cost) return;
    measure(face);
    face.cost += deviation_cost * face.deviation;
    if (!(face.cost <= greatest_free_cost)) return;
    if (crosses_itself(graph_.polygon(path_, crossing_step), face.normal)) return;
    face.loops = {path_};
    for (const Index half : path_) face.edges.push_back(half / 2);
    std::ranges::sort(face.edges);
    face.planar = face.flatness <= flat_loop * graph_.size;
    result_.candidates.push_back(std::move(face));
  }

  void measure(FaceCandidate& face) const {
    const std::vector<Vec3> polygon = graph_.polygon(path_, 2);
    const Vec3 normal = area_normal(polygon);
    for (const Vec3& p : polygon) face.origin += p / static_cast<double>(polygon.size());
    face.normal = unit_or_zero(normal);
    double squares = 0;
    for (const Vec3& p : polygon) {
      const double distance = face.normal.dot(p - face.origin);
      squares += distance * distance;
      face.flatness = std::max(face.flatness, std::abs(distance));
    }
    face.deviation = std::sqrt(squares / static_cast<double>(polygon.size()) / normal.norm());
  }

  const SolidGraph& graph_;
  FreeFaceKind kind_;
  std::size_t max_sides_;
  std::vector<std::vector<Index>> planes_at_;
  std::vector<std::uint8_t> on_path_, allowed_;
  std::vector<Index> steps_, path_;
  std::size_t looked_at_ = 0;
  FreeFaces result_;
};

}  // namespace

FreeFaces free_faces(const SolidGraph& graph, const std::vector<EdgePlane>& planes, const FreeFaceSearch& search,
                     Progress& progress) {
  return LoopSearch(graph, planes, search).run(progress);
}

}  // namespace croquis
