// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/limit/limit_rows.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::subdivision {
namespace {

/// Lists 0 … keys.size()-1 by key; no_index keys are left out.
IndexTable grouped(const std::vector<Index>& keys, std::size_t key_count) {
  IndexTable table;
  table.offsets.assign(key_count + 1, 0);
  for (const Index key : keys) table.offsets[key == no_index ? 0 : key + std::size_t{1}] += key == no_index ? 0 : 1;
  std::partial_sum(table.offsets.begin(), table.offsets.end(), table.offsets.begin());
  table.values.resize(table.offsets.back());
  std::vector<Index> place(table.offsets.begin(), table.offsets.end() - 1);
  for (Index i = 0; i < keys.size(); ++i) {
    if (keys[i] != no_index) table.values[place[keys[i]]++] = i;
  }
  return table;
}

/// Reads the limit of the vertices of level k off level k+1. All rows are over level k+1.
class Reader {
 public:
  Reader(const DooSabinPlan& plan, int k)
      : plan_(plan),
        next_(k + 1),
        ends_stay_(plan.rules().chain_ends == ChainEnds::Pin),
        mesh_(plan.level(k).topology),
        around_(mesh_),
        child_(plan.level(k + 1).topology),
        child_around_(child_),
        child_sharpness_(edge_sharpness(plan.level(k + 1))) {
    rows_.level = next_;
    std::vector<Index> vertex_of_point(child_.vertex_count());
    for (Index p = 0; p < vertex_of_point.size(); ++p) vertex_of_point[p] = plan.vertex_origin(next_, p).vertex;
    points_ = grouped(vertex_of_point, mesh_.vertex_count());
    std::vector<Index> vertex_of_face(child_.face_count(), no_index);
    for (Index f = 0; f < vertex_of_face.size(); ++f) {
      const FaceOrigin origin = plan.face_origin(next_, f);
      if (origin.kind == FaceKind::Vertex) vertex_of_face[f] = origin.element;
    }
    faces_ = grouped(vertex_of_face, mesh_.vertex_count());
    rows_.corner_normal.assign(mesh_.corner_count(), no_index);
    rows_.exact.assign(mesh_.vertex_count(), 1);
  }

  LimitRows read(Progress& progress) {
    for (Index vertex = 0; vertex < mesh_.vertex_count(); ++vertex) {
      read_vertex(vertex);
      if (vertex % 65536 == 0) progress.report(vertex / static_cast<double>(mesh_.vertex_count()));
    }
    progress.report(1);
    return std::move(rows_);
  }

 private:
  void read_vertex(Index vertex) {
    std::vector<Index> chain_points;
    for (const Index point : points_[vertex]) {
      const PointKind kind = plan_.vertex_origin(next_, point).kind;
      if (kind == PointKind::Kept) return read_kept(vertex, point);
      if (kind == PointKind::Chain) chain_points.push_back(point);
    }
    if (chain_points.size() == 2) return read_crease(vertex, chain_points[0], chain_points[1]);
    const bool pinned_end = chain_points.size() == 1 && (ends_stay_ || pinned(chain_points[0]));
    read_inner(vertex, pinned_end ? chain_points[0] : no_index);
  }

  /// Smooth vertices and ends of chains: the centre of the face that the vertex becomes.
  void read_inner(Index vertex, Index pinned_end) {
    const auto faces = faces_[vertex];
    const auto ring = faces.empty() ? points_[vertex] : child_.face(faces[0]);
    if (pinned_end != no_index) {
      add_mean({&pinned_end, 1});
      rows_.exact[vertex] = stays(pinned_end) ? 1 : 0;
    } else {
      add_mean(ring);
      rows_.exact[vertex] = faces.empty() ? 0 : 1;
    }
    if (faces.empty()) return;
    const Index normal = add_fourier_normal(ring);
    for_each_corner(mesh_, around_, vertex, [&](Index corner) { rows_.corner_normal[corner] = normal; });
  }

  /// A vertex that stays. Its normals are those of its corners in the faces' own children, along sharp edges exact.
  void read_kept(Index vertex, Index point) {
    add_mean({&point, 1});
    rows_.exact[vertex] = stays(point) ? 1 : 0;
    std::vector<std::pair<Index, Index>> normal_of_face;
    for_each_corner(child_, child_around_, point, [&](Index corner) {
      const FaceOrigin origin = plan_.face_origin(next_, child_around_.face(corner));
      if (origin.kind != FaceKind::Face) return;
      const Index after = child_.corner_vertex[child_around_.next(corner)];
      const Index before = child_.corner_vertex[child_around_.previous(corner)];
      normal_of_face.emplace_back(origin.element, add_corner_normal(point, after, before));
    });
    for_each_corner(mesh_, around_, vertex, [&](Index corner) {
      for (const auto& [face, normal] : normal_of_face) {
        if (face == around_.face(corner)) rows_.corner_normal[corner] = normal;
      }
    });
  }

  bool pinned(Index point) const {
    const auto& pins = plan_.level(next_).pins;
    return std::binary_search(pins.begin(), pins.end(), point);
  }

  /// Whether enough edges at a kept point are infinitely sharp to keep it there.
  bool stays(Index point) const {
    std::size_t edges = 0, faces = 0;
    const auto count = [&](Index corner) {
      if (child_sharpness_[child_.corner_edge[corner]] == infinite_sharpness) ++edges;
    };
    Index last = no_index;
    for_each_corner(child_, child_around_, point, [&](Index corner) {
      count(corner);
      last = child_around_.previous(corner);
      ++faces;
    });
    const bool on_boundary = child_.twin[last] == no_index;
    if (on_boundary) count(last);
    const bool held = pinned(point) ? edges > 0 : ends_stay_ && edges == 1;
    return edges > 2 || held || (on_boundary && faces == 1);
  }

  /// The middle of the chord between the two points of a chain's vertex: (A + 6V + B)/8.
  void read_crease(Index vertex, Index a, Index b) {
    const std::array<Index, 2> ends = {a, b};
    add_mean(ends);
    const Index half_edge = half_edge_between(a, b);
    if (half_edge == no_index) {
      rows_.exact[vertex] = 0;
      return;
    }
    rows_.exact[vertex] = child_sharpness_[child_.corner_edge[half_edge]] == infinite_sharpness ? 1 : 0;
    set_side_normals(vertex, a, b);
  }

  /// Corners from the edge of `a` counter-clockwise to that of `b` lie beside the half-edge from b to a, and the others
  /// beside the one from a to b.
  void set_side_normals(Index vertex, Index a, Index b) {
    const Index edge_a = plan_.vertex_origin(next_, a).element;
    const Index edge_b = plan_.vertex_origin(next_, b).element;
    const Index normal_ab = add_side_normal(a, b);
    const Index normal_ba = add_side_normal(b, a);
    const Index start = mesh_.vertex_corner[vertex];
    Index current = no_index;
    Index first_known = no_index;
    for_each_corner(mesh_, around_, vertex, [&](Index corner) {
      if (mesh_.corner_edge[corner] == edge_a) current = normal_ba;
      if (mesh_.corner_edge[corner] == edge_b) current = normal_ab;
      if (first_known == no_index && current != no_index) first_known = corner;
      rows_.corner_normal[corner] = current;
    });
    if (first_known == start) return;
    bool before = true;  // the sector that the walk began within
    for_each_corner(mesh_, around_, vertex, [&](Index corner) {
      before = before && corner != first_known;
      if (before) rows_.corner_normal[corner] = current;
    });
  }

  /// The half-edge from a to b or, where only that is there, from b to a.
  Index half_edge_between(Index a, Index b) const {
    const Index forward = half_edge(a, b);
    return forward != no_index ? forward : half_edge(b, a);
  }

  Index half_edge(Index from, Index to) const {
    Index found = no_index;
    for_each_corner(child_, child_around_, from, [&](Index corner) {
      if (child_.corner_vertex[child_around_.next(corner)] == to) found = corner;
    });
    return found;
  }

  void add_mean(std::span<const Index> points) {
    for (const Index point : points) rows_.points.add(point, 1 / static_cast<double>(points.size()));
    rows_.points.end_row();
  }

  Index end_normal() {
    rows_.first_tangents.end_row();
    rows_.second_tangents.end_row();
    return static_cast<Index>(rows_.first_tangents.size() - 1);
  }

  Index add_fourier_normal(std::span<const Index> ring) {
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(ring.size());
      rows_.first_tangents.add(ring[j], std::cos(angle));
      rows_.second_tangents.add(ring[j], std::sin(angle));
    }
    return end_normal();
  }

  Index add_corner_normal(Index point, Index after, Index before) {
    rows_.first_tangents.add(after, 1);
    rows_.first_tangents.add(point, -1);
    rows_.second_tangents.add(before, 1);
    rows_.second_tangents.add(point, -1);
    return end_normal();
  }

  /// (V2 - V1) x (V3 + V4 - V1 - V2) in the face of the half-edge from V1 to V2; no_index where it has none.
  Index add_side_normal(Index from, Index to) {
    const Index corner = half_edge(from, to);
    if (corner == no_index) return no_index;
    const auto face = child_.face(child_around_.face(corner));
    rows_.first_tangents.add(to, 1);
    rows_.first_tangents.add(from, -1);
    for (const Index point : face) {
      const bool on_edge = point == from || point == to;
      rows_.second_tangents.add(point, on_edge ? -1 : 2 / static_cast<double>(face.size() - 2));
    }
    return end_normal();
  }

  const DooSabinPlan& plan_;
  int next_;
  bool ends_stay_;
  const HalfEdges& mesh_;
  CornerFaces around_;
  const HalfEdges& child_;
  CornerFaces child_around_;
  std::vector<double> child_sharpness_;
  IndexTable points_;  ///< of level k+1, by the vertex of level k that they stand for
  IndexTable faces_;   ///< of level k+1, by the vertex that they were born from
  LimitRows rows_;
};

}  // namespace

LimitRows doo_sabin_limit(const DooSabinPlan& plan, int k, Progress& progress) {
  return Reader(plan, k).read(progress);
}

}  // namespace croquis::subdivision
