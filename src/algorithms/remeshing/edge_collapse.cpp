// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/surface_parts.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/hole_filling/editable_triangles.h"

namespace croquis::remeshing {
namespace {

using hole_filling::EditableTriangles;
using Side = EditableTriangles::Side;

constexpr double least_turn = 0.70710678118654752;  // cosine of what a triangle may turn by
constexpr double least_sine = 0.25881904510252076;  // of new triangles' angles, unless there are smaller ones around
constexpr double evenness = 0.03;                   // what an edge's length counts for beside how far it leads off
constexpr double clearly_near = 0.5;                // × what is allowed: no nearer triangle is looked for
constexpr std::size_t steps_between_checks = 1024;  // of the cancel flag

/// A vertex that may go, and what that costs at least.
struct Candidate {
  double cost = 0;
  Index vertex = 0;

  auto operator<=>(const Candidate&) const = default;
};

/// An edge by which a vertex may go.
struct Collapse {
  double cost = 0;
  Index to = 0;
  Side side = 0;

  auto operator<=>(const Collapse&) const = default;
};

using Corners = std::array<Vec3, 3>;

Vec3 normal_of(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Sine of the least angle: that between the two longer edges.
double sine_of(const Corners& t) {
  std::array<double, 3> lengths = {(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()};
  std::ranges::sort(lengths);
  return lengths[1] > 0 ? normal_of(t).norm() / (lengths[1] * lengths[2]) : 0;
}

std::vector<std::array<Index, 3>> corners_by_face(const PolyMesh& mesh) {
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(mesh.face_count());
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3)
    triangles.push_back({mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]});
  return triangles;
}

class Collapsing {
 public:
  Collapsing(const PolyMesh& mesh, std::span<const VertexRole> roles, const CollapseLimits& limits)
      : at_(mesh.positions),
        roles_(roles),
        limits_(limits),
        sides_(corners_by_face(mesh), mesh.vertex_count()),
        first_(mesh.face_count(), no_index),
        next_(mesh.vertex_count(), no_index),
        is_queued_(mesh.vertex_count(), 0),
        seen_(mesh.vertex_count(), 0) {
    put_points();
  }

  CollapsedMesh run(Progress& progress) {
    for (Side s = 0; s < sides_.count(); ++s) queue(sides_.from(s), s);
    const std::size_t all = queue_.size();
    std::size_t gone = 0;
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % steps_between_checks == 0) progress.report(static_cast<double>(gone) / static_cast<double>(all));
      const Candidate best = queue_.top();
      queue_.pop();
      is_queued_[best.vertex] = 0;
      look_around(sides_.out(best.vertex));
      if (collapses_.empty()) continue;
      const double cost = std::ranges::min_element(collapses_)->cost;
      if (cost > best.cost && !queue_.empty() && cost > queue_.top().cost) {  // something has changed around it
        queue_.push({cost, best.vertex});
        is_queued_[best.vertex] = 1;
        continue;
      }
      if (collapse()) ++gone;
    }
    progress.report(1);
    return rest();
  }

 private:
  /// Edges that nothing changes are left out.
  void put_points() {
    for (Side s = 0; s < sides_.count(); ++s) {
      const Index a = sides_.from(s), b = sides_.to(s);
      if (!sides_.is_inner_edge(s) || (roles_[a] == VertexRole::Fenced && roles_[b] == VertexRole::Fenced)) continue;
      edges_.push_back({a, b});
      next_.push_back(std::exchange(first_[s / 3], static_cast<Index>(next_.size())));
    }
  }

  Vec3 place_of(Index point) const {
    if (point < at_.size()) return at_[point];
    const auto& [a, b] = edges_[point - at_.size()];
    return 0.5 * (at_[a] + at_[b]);
  }

  double allowed(Index point) const {
    if (point < at_.size()) return std::ldexp(limits_.off, -limits_.halvings[point]);
    const auto& [a, b] = edges_[point - at_.size()];
    return std::ldexp(limits_.off, -std::max(limits_.halvings[a], limits_.halvings[b]));
  }

  /// @param out a side out of the vertex
  template <typename Visit>
  void for_each_neighbour(Side out, const Visit& visit) const {
    Side s = out;
    do {
      visit(sides_.to(s), s);
      const Side back = EditableTriangles::previous(s);
      s = sides_.twin(back);
      if (s == EditableTriangles::none) visit(sides_.from(back), EditableTriangles::none);
    } while (s != out && s != EditableTriangles::none);
    if (s == out) return;
    for (s = sides_.twin(out); s != EditableTriangles::none; s = sides_.twin(s)) {
      s = EditableTriangles::next(s);
      visit(sides_.to(s), s);
    }
  }

  /// The sides out of a Free vertex, and what it costs to go along them.
  void look_around(Side out) {
    around_.clear();
    collapses_.clear();
    Side s = out;
    do {
      around_.push_back(s);
      s = sides_.twin(EditableTriangles::previous(s));
    } while (s != out);
    for (const Side side : around_) {
      if (roles_[sides_.to(side)] == VertexRole::Fenced) continue;
      collapses_.push_back({0, sides_.to(side), side});
    }
    for (const Side side : around_) {
      const Corners t = corners(side);
      const Vec3 normal = normal_of(t);
      const double length = normal.norm();
      for (Collapse& edge : collapses_) {
        const Vec3 step = at_[edge.to] - t[0];
        const double off = length > 0 ? normal.dot(step) / length : 0;
        edge.cost += length * (off * off + evenness * evenness * step.squaredNorm());
      }
    }
  }

  void queue(Index v, Side out) {
    if (roles_[v] != VertexRole::Free || is_queued_[v] != 0 || out == EditableTriangles::none) return;
    look_around(out);
    if (collapses_.empty()) return;
    queue_.push({std::ranges::min_element(collapses_)->cost, v});
    is_queued_[v] = 1;
  }

  /// No neighbours in common but the two beyond the edge's triangles, and no triangle folded onto another.
  bool keeps_topology(const Collapse& edge) {
    ++look_;
    for (const Side s : around_) seen_[sides_.to(s)] = look_;
    std::size_t common = 0;
    for_each_neighbour(sides_.twin(edge.side), [&](Index v, Side) { common += seen_[v] == look_ ? 1U : 0U; });
    if (common != 2) return false;
    return std::ranges::all_of(around_, [&](Side s) {
      const Side beyond = sides_.twin(EditableTriangles::next(s));
      return is_lost(s, edge.side) || beyond == EditableTriangles::none || sides_.apex(beyond) != edge.to;
    });
  }

  bool keeps_shape(const Collapse& edge) {
    made_.clear();
    double worst = least_sine;
    for (const Side s : around_) worst = std::min(worst, sine_of(corners(s)));
    const Vec3& place = at_[edge.to];
    for (const Side s : around_) {
      if (is_lost(s, edge.side)) continue;
      const Corners before = corners(s);
      const Corners after = {place, before[1], before[2]};
      const Vec3 was = normal_of(before), is = normal_of(after);
      if (!(is.dot(was) > least_turn * is.norm() * was.norm())) return false;
      if ((after[1] - place).squaredNorm() > limits_.longest * limits_.longest) return false;
      if (sine_of(after) < worst) return false;
      made_.emplace_back(s / 3, after);
    }
    return true;
  }

  /// Some triangle that is near enough, if not the nearest.
  bool takes(Index point) {
    const Vec3 place = place_of(point);
    const double most = allowed(point);
    double least = std::numeric_limits<double>::infinity();
    Index home = no_index;
    for (const auto& [triangle, corners] : made_) {
      const double distance = foot_on_triangle(corners, place).distance;
      if (distance >= least) continue;
      least = distance;
      home = triangle;
      if (least < clearly_near * most) break;
    }
    new_homes_.emplace_back(point, home);
    return least <= most;
  }

  bool keeps_points(const Collapse& edge) {
    new_homes_.clear();
    if (!takes(sides_.from(edge.side))) return false;
    for (const Side s : around_)
      for (Index point = first_[s / 3]; point != no_index; point = next_[point])
        if (!takes(point)) return false;
    return true;
  }

  void go(const Collapse& edge) {
    for (const Side s : around_) first_[s / 3] = no_index;
    for (const auto& [point, home] : new_homes_) next_[point] = std::exchange(first_[home], point);
    Side out = EditableTriangles::none;  // out of the vertex that is left
    for (const Side s : around_)
      if (!is_lost(s, edge.side)) out = s;
    sides_.collapse(edge.side);
    std::vector<std::pair<Index, Side>> changed = {{edge.to, out}};
    for_each_neighbour(
        out, [&](Index v, Side s) { changed.emplace_back(v, s == EditableTriangles::none ? s : sides_.twin(s)); });
    for (const auto& [v, side] : changed) queue(v, side);
  }

  /// Of the vertex looked at.
  bool collapse() {
    std::ranges::sort(collapses_);
    for (const Collapse& edge : collapses_) {
      if (!keeps_topology(edge) || !keeps_shape(edge) || !keeps_points(edge)) continue;
      go(Collapse(edge));
      return true;
    }
    return false;
  }

  CollapsedMesh rest() const {
    CollapsedMesh rest;
    rest.home.assign(at_.size(), no_index);
    for (Side s = 0; s < sides_.count(); s += 3) {
      if (sides_.from(s) == EditableTriangles::none) continue;
      for (Index point = first_[s / 3]; point != no_index; point = next_[point])
        if (point < at_.size()) rest.home[point] = static_cast<Index>(rest.triangles.size());
      rest.triangles.push_back({sides_.from(s), sides_.from(s + 1), sides_.from(s + 2)});
      rest.face_of.push_back(s / 3);
    }
    return rest;
  }

  Corners corners(Side s) const { return places_of(at_, std::array{sides_.from(s), sides_.to(s), sides_.apex(s)}); }
  bool is_lost(Side around, Side s) const { return around / 3 == s / 3 || around / 3 == sides_.twin(s) / 3; }

  const std::vector<Vec3>& at_;
  std::span<const VertexRole> roles_;
  const CollapseLimits& limits_;
  EditableTriangles sides_;
  std::vector<std::array<Index, 2>> edges_;  // of the mesh given
  std::vector<Index> first_, next_;          // lists of points on each triangle: vertices gone, and middles of edges
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  std::vector<std::uint8_t> is_queued_;
  std::vector<std::uint32_t> seen_;  // per vertex: at which look it was a neighbour last
  std::uint32_t look_ = 0;
  std::vector<Side> around_;
  std::vector<Collapse> collapses_;
  std::vector<std::pair<Index, Corners>> made_;     // triangles of a collapse, where it would leave them
  std::vector<std::pair<Index, Index>> new_homes_;  // points, and their triangles
};

}  // namespace

CollapsedMesh collapse_edges(const PolyMesh& mesh, std::span<const VertexRole> roles, const CollapseLimits& limits,
                             Progress& progress) {
  return Collapsing(mesh, roles, limits).run(progress);
}

}  // namespace croquis::remeshing
