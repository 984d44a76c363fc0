// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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
  std::vector<bool> one_sided;       ///< #V of the topology: lies at a cut or at the boundary
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
    if (sharp_edges < 2) return;
    cut_.one_sided[vertex] = true;
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
        if (corner) cut_.topology.pins.push_back(current);
      }
      cut_.topology.corners[c] = current;
    }
  }

  const HalfEdges& mesh_;
  CornerFaces around_;
  std::vector<double> sharpness_;
  std::vector<std::uint8_t> pinned_;
  UniformRules rules_;
  CutLevel cut_;
};

/// Rows of the cut level's vertices, over the level's: those at cuts from `sides`, the others from `whole`.
WeightRows merged(const WeightRows& whole, const WeightRows& sides, const CutLevel& cut) {
  WeightRows rows;
  for (std::size_t v = 0; v < cut.source_vertex.size(); ++v) {
    const WeightRows& from = cut.one_sided[v] ? sides : whole;
    for (Index i = from.offsets[v]; i < from.offsets[v + 1]; ++i) {
      rows.add(cut.source_vertex[from.columns[i]], from.weights[i]);
    }
    rows.end_row();
  }
  return rows;
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
  rows.first_tangents = merged(limits.first_tangent, sides.first_tangent, cut);
  rows.second_tangents = merged(limits.second_tangent, sides.second_tangent, cut);
  rows.corner_normal = cut.topology.corners;
  rows.exact = exact_vertices(level);
  return rows;
}

}  // namespace croquis::subdivision
