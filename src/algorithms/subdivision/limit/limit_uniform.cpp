// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/limit/limit_rows.h"
#include "algorithms/subdivision/opensubdiv/primal_refinement.h"

namespace croquis::subdivision {
namespace {

/// A level cut open along its edges that stay sharp, so that OpenSubdiv's tangents at its boundary are one-sided. Ends
/// of chains are not cut: the surface is smooth there.
struct CutLevel {
  PrimalTopology topology;
  std::vector<Index> source_vertex;  ///< #V of the topology -> vertex of the level
  std::vector<bool> one_sided;       ///< #V of the topology: lies at a cut, at the boundary, or is pinned
  /// Of the topology's vertices that stay where they are: the corners of their faces, counter-clockwise from the one
  /// sharp edge to the other.
  std::map<Index, std::vector<Index>> fans;
};

class LevelCutter {
 public:
  LevelCutter(const Level& level, const UniformRules& rules)
      : mesh_(level.topology), around_(mesh_), sharpness_(edge_sharpness(level)), rules_(rules) {
    cut_.topology = primal_topology(level, rules);
    cut_.topology.rules.boundary_corners = BoundaryCorners::Smooth;  // sectors of one face aren't corners
    cut_.topology.creases.clear();
    cut_.topology.pins.clear();
    pinned_.assign(mesh_.vertex_count(), 0);
    for (const Index vertex : level.pins) pinned_[vertex] = 1;
  }

  CutLevel cut() {
    for (Index vertex = 0; vertex < mesh_.vertex_count(); ++vertex) cut_.source_vertex.push_back(vertex);
    cut_.one_sided.assign(mesh_.vertex_count(), false);
    for (Index vertex = 0; vertex < mesh_.vertex_count(); ++vertex) cut_vertex(vertex);
    cut_.one_sided.resize(cut_.source_vertex.size(), true);
    cut_.topology.vertex_count = cut_.source_vertex.size();
    return std::move(cut_);
  }

 private:
  bool stays_sharp(Index corner) const { return sharpness_[mesh_.corner_edge[corner]] == infinite_sharpness; }

  void cut_vertex(Index vertex) {
    std::vector<Index> fan;
    for_each_corner(mesh_, around_, vertex, [&](Index corner) { fan.push_back(corner); });
    auto starts = std::count_if(fan.begin(), fan.end(), [&](Index corner) { return stays_sharp(corner); });
    const bool open = mesh_.twin[fan[0]] == no_index;
    const auto sharp_edges = starts + (open ? 1 : 0);
    const bool lone = open && fan.size() == 1 && rules_.boundary_corners == BoundaryCorners::Corner;
    const bool corner = sharp_edges > 2 || pinned_[vertex] != 0 || lone;
    // A pin alone makes no sides, but its tangents, too, are those of the surface that isn't pinned.
    cut_.one_sided[vertex] = sharp_edges > 1 || pinned_[vertex] != 0;
    if (sharp_edges < 2) return;
    if (!open) {
      std::rotate(fan.begin(), std::find_if(fan.begin(), fan.end(), [&](Index c) { return stays_sharp(c); }),
                  fan.end());
    }
    number_sectors(vertex, fan, corner);
  }

  /// The first sector keeps the vertex, each further one gets a new one.
  void number_sectors(Index vertex, const std::vector<Index>& fan, bool corner) {
    Index current = no_index;
    for (const Index c : fan) {
      if (stays_sharp(c)) {
        const bool first = current == no_index;
        current = first ? vertex : static_cast<Index>(cut_.source_vertex.size());
        if (!first) cut_.source_vertex.push_back(vertex);
      }
      cut_.topology.corners[c] = current;
      if (corner) cut_.fans[current].push_back(c);
    }
  }

  const HalfEdges& mesh_;
  CornerFaces around_;
  std::vector<double> sharpness_;
  std::vector<std::uint8_t> pinned_;
  UniformRules rules_;
  CutLevel cut_;
};

/// The slowest movement of a fan's inner points that is alike seen from both of its sharp edges E and F. With the
/// vertex that stays as origin, a refinement takes its size m to shrinking * m + of_edges * (E + F).
struct FanMode {
  std::vector<double> edges;  ///< n + 1 weights of the ends of edges, 0 for both sharp ones
  std::vector<double> faces;  ///< n weights of face points, 0 for Loop
  double shrinking = 0;
  double of_edges = 0;
};

FanMode fan_mode(UniformScheme scheme, std::size_t n) {
  const double angle = std::numbers::pi / static_cast<double>(n);
  FanMode mode;
  for (std::size_t i = 0; i <= n; ++i) mode.edges.push_back(std::sin(static_cast<double>(i) * angle));
  mode.edges.back() = 0;
  mode.faces.assign(n, 0);
  if (scheme == UniformScheme::Loop) {
    mode.shrinking = 3.0 / 8 + std::cos(angle) / 4;
    mode.of_edges = mode.edges[1] / 8;
    return mode;
  }
  // With a face point for every sine, (4 l - 1)^2 = 4 l cos^2(angle / 2) for the eigenvalue l.
  const double square = (1 + std::cos(angle)) / 2;
  mode.shrinking = (1 + square / 2 + std::sqrt(square + square * square / 4)) / 4;
  for (std::size_t i = 0; i < n; ++i) {
    mode.faces[i] = (mode.edges[i] + mode.edges[i + 1]) / (16 * mode.shrinking - 4);
  }
  mode.of_edges = mode.faces[0] / 4 + mode.edges[1] / 16;
  return mode;
}

/// Two tangents at a vertex that stays, on one side. The second is the difference of the sharp edges. The first is
/// their sum where the surface has a tangent plane. With more faces it has none: the inner points shrink as slowly as
/// the sharp edges or slower, so the surface ends in a cone whose slope goes on changing from level to level. There the
/// first tangent is the fan's mode as it was on level 1, which is the same seen from every level.
void add_fan_tangents(const UniformPlan& plan, int k, const CornerFaces& around, const std::vector<Index>& fan,
                      LimitRows& rows) {
  const HalfEdges& mesh = plan.level(k).topology;
  const Index vertex = mesh.corner_vertex[fan[0]];
  std::vector<Index> ends;
  for (const Index corner : fan) ends.push_back(mesh.corner_vertex[around.next(corner)]);
  ends.push_back(mesh.corner_vertex[around.previous(fan.back())]);
  rows.second_tangents.add(ends.back(), 1);
  rows.second_tangents.add(ends.front(), -1);
  rows.second_tangents.end_row();

  double of_vertex = 0;
  const auto add = [&](Index to, double weight) {
    rows.first_tangents.add(to, weight);
    of_vertex -= weight;
  };
  const UniformScheme scheme = plan.rules().scheme;
  const FanMode mode = fan_mode(scheme, fan.size());
  double of_sum = 1;
  constexpr double slowest_with_plane = 0.49;  // the next one is a half
  if (mode.shrinking > slowest_with_plane) {
    of_sum = 0;
    for (int level = 0; level < k; ++level) of_sum -= mode.of_edges * std::pow(2 * mode.shrinking, level);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const double beside = mode.edges[i] + mode.edges[i + 1];
      if (scheme == UniformScheme::Loop) {
        add(ends[i], 3.0 / 8 * mode.edges[i] + mode.edges[i + 1] / 8);
        add(ends[i + 1], mode.edges[i] / 8);
        continue;
      }
      add(ends[i], mode.edges[i] / 4);
      const auto face = mesh.face(around.face(fan[i]));
      for (const Index corner : face) add(corner, (mode.faces[i] + beside / 4) / static_cast<double>(face.size()));
    }
  }
  for (const Index end : {ends.front(), ends.back()}) add(end, of_sum);
  rows.first_tangents.add(vertex, of_vertex);
  rows.first_tangents.end_row();
}

/// Tangents of the cut level's vertices, over the level's: those at cuts one-sided, the others of the whole surface.
void set_tangents(const UniformPlan& plan, int k, const PrimalLimit& whole, const PrimalLimit& sides,
                  const CutLevel& cut, LimitRows& rows) {
  const CornerFaces around(plan.level(k).topology);
  const auto copy_row = [&](const WeightRows& from, std::size_t v, WeightRows& to) {
    for (Index i = from.offsets[v]; i < from.offsets[v + 1]; ++i) {
      to.add(cut.source_vertex[from.columns[i]], from.weights[i]);
    }
    to.end_row();
  };
  for (Index v = 0; v < cut.source_vertex.size(); ++v) {
    if (const auto fan = cut.fans.find(v); fan != cut.fans.end()) {
      add_fan_tangents(plan, k, around, fan->second, rows);
      continue;
    }
    const PrimalLimit& from = cut.one_sided[v] ? sides : whole;
    copy_row(from.first_tangent, v, rows.first_tangents);
    copy_row(from.second_tangent, v, rows.second_tangents);
  }
}

/// OpenSubdiv's limit masks are near the limit only at ends of chains, for which it takes the smooth one, at inner
/// vertices of two faces, and where sharpness runs out.
std::vector<std::uint8_t> exact_vertices(const Level& level) {
  const HalfEdges& mesh = level.topology;
  struct Around {
    int sharp_edges = 0;
    int faces = 0;
    bool fading = false;
    bool on_boundary = false;
  };
  std::vector<Around> around(mesh.vertex_count());
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = mesh.edge_corner[sharp.edge];
    for (const Index vertex : {mesh.corner_vertex[corner], mesh.corner_vertex[mesh.twin[corner]]}) {
      ++around[vertex].sharp_edges;
      around[vertex].fading = around[vertex].fading || sharp.sharpness != infinite_sharpness;
    }
  }
  for (const Index vertex : mesh.corner_vertex) ++around[vertex].faces;
  for (const Index corner : level.boundary) around[mesh.corner_vertex[corner]].on_boundary = true;
  std::vector<std::uint8_t> exact(around.size());
  for (std::size_t v = 0; v < exact.size(); ++v) {
    const bool inner = !around[v].on_boundary;
    const bool end_of_chain = inner && around[v].sharp_edges == 1;
    const bool two_faces = inner && around[v].sharp_edges == 0 && around[v].faces == 2;
    exact[v] = around[v].fading || end_of_chain || two_faces ? 0 : 1;
  }
  for (const Index pin : level.pins) exact[pin] = 1;
  return exact;
}

}  // namespace

LimitRows uniform_limit(const UniformPlan& plan, int k, Progress& progress) {
  const Level& level = plan.level(k);
  const HalfEdges& mesh = level.topology;
  LimitRows rows;
  rows.level = k;
  if (mesh.face_count() == 0) return rows;
  PrimalTopology whole = primal_topology(level, plan.rules());
  std::erase_if(whole.creases, [](const Crease& crease) { return crease.sharpness != infinite_sharpness; });
  const CutLevel cut = LevelCutter(level, plan.rules()).cut();
  Progress first = progress.step("limit of the surface", 0.5);
  PrimalLimit limits = limit(whole, first);
  Progress second = progress.step("limit beside sharp edges", 0.5);
  const bool any_cut = std::find(cut.one_sided.begin(), cut.one_sided.end(), true) != cut.one_sided.end();
  const PrimalLimit sides = any_cut ? limit(cut.topology, second) : PrimalLimit();
  rows.points = std::move(limits.points);
  set_tangents(plan, k, limits, sides, cut, rows);
  rows.corner_normal = cut.topology.corners;
  rows.exact = exact_vertices(level);
  return rows;
}

}  // namespace croquis::subdivision
