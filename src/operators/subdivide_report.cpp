// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivide_report.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace croquis {
using namespace subdivision;

const char* to_string(SubdivisionScheme scheme) {
  constexpr std::array<const char*, 3> names = {"doo-sabin", "catmull-clark", "loop"};
  return names[static_cast<std::size_t>(scheme)];
}

std::vector<LevelCounts> level_counts(const SubdivisionPlan& plan, int last) {
  std::vector<LevelCounts> counts;
  for (int k = 0; k <= last; ++k) {
    const Level& level = level_of(plan, k);
    counts.push_back({level.topology.vertex_count(), level.topology.edge_count(), level.topology.face_count(),
                      level.boundary.size(), level.sharp.size()});
  }
  return counts;
}

std::vector<SharpChain> sharp_chains(const Level& level, std::span<const EdgeChain> chains,
                                     std::span<const Vec3> positions, std::span<const std::vector<CageEdge>> origins) {
  const std::vector<ChainShape> shapes = chain_shapes(level, chains, positions);
  std::vector<SharpChain> list;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const ChainShape& shape = shapes[i];
    list.push_back({chains[i].edges.size(), chains[i].closed, chains[i].ends, shape.least_bend, shape.greatest_bend,
                    shape.side_bends, shape.length, shape.planar(), shape.deviation, origins[i]});
  }
  return list;
}

std::vector<std::vector<CageEdge>> chain_origins(const SubdivisionPlan& plan, int k, std::span<const EdgeChain> chains,
                                                 const Cage& cage) {
  const auto edge_of_mesh = [&](Index a, Index b) {
    const auto [low, high] = std::minmax(cage.source_vertex[a], cage.source_vertex[b]);
    return CageEdge{low, high};
  };
  const auto origins_of = [&](const auto& add_origins) {
    std::vector<std::vector<CageEdge>> all;
    for (const EdgeChain& chain : chains) {
      std::set<CageEdge> found;
      for (std::size_t edge = 0; edge < chain.edges.size(); ++edge) add_origins(chain, edge, found);
      all.emplace_back(found.begin(), found.end());
    }
    return all;
  };
  if (const auto* doo_sabin = std::get_if<DooSabinPlan>(&plan)) {
    // The child of an edge joins what its ends became; a chord joins two points of one vertex.
    return origins_of([&](const EdgeChain& chain, std::size_t edge, std::set<CageEdge>& found) {
      const Index a = doo_sabin->cage_vertex(k, chain.vertices[edge]);
      const Index b = doo_sabin->cage_vertex(k, chain.vertices[(edge + 1) % chain.vertices.size()]);
      if (a != b) found.insert(edge_of_mesh(a, b));
    });
  }
  const UniformPlan& uniform = std::get<UniformPlan>(plan);
  const HalfEdges& fine = uniform.level(k).topology;
  const HalfEdges& coarse = cage.topology;
  const CornerFaces faces(fine), cage_faces(coarse);
  // The child of an edge lies between children of its faces.
  return origins_of([&](const EdgeChain& chain, std::size_t edge, std::set<CageEdge>& found) {
    const Index corner = fine.edge_corner[chain.edges[edge]];
    const Index left = uniform.cage_face(k, faces.face(corner));
    const Index right = uniform.cage_face(k, faces.face(fine.twin[corner]));
    for (Index c = coarse.face_offsets[left]; c < coarse.face_offsets[left + std::size_t{1}]; ++c) {
      if (coarse.twin[c] == no_index || cage_faces.face(coarse.twin[c]) != right) continue;
      if (!(cage.sharpness[coarse.corner_edge[c]] > 0)) continue;
      found.insert(edge_of_mesh(coarse.corner_vertex[c], coarse.corner_vertex[coarse.twin[c]]));
    }
  });
}

std::vector<double> continuity_angles(const ContinuityReport& report, int last) {
  std::vector<double> angles;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(last); ++k) angles.push_back(report.levels[k].greatest_bend);
  return angles;
}

Report to_report(const SubdivideResult& result) {
  Report details = to_report(fields(named("scheme", result.scheme), named("levels", result.levels)));
  if (!result.judged) return details;
  Report continuity = Report::array();
  for (const double angle : result.continuity) continuity.push(in_degrees(angle));
  details.set("chains", to_report(result.chains)).set("continuity", std::move(continuity));
  details.set("verdict", result.verdict);
  return details;
}

std::size_t byte_size(const SubdivideResult& result) {
  return sizeof result + heap_size(result.levels) + heap_size(result.chains) + heap_size(result.continuity) +
         heap_size(result.verdict);
}

PolyMesh curve_lines(std::span<const ChainCurve> curves, double tolerance) {
  PolyMesh lines;
  AttributeChannel objects{"object", Domain::Line, 1, std::vector<std::int32_t>(), {}};
  for (const ChainCurve& curve : curves) {
    const std::vector<Vec3> points = sampled(curve, tolerance);
    std::vector<Index> vertices;
    for (const Vec3& point : points) {
      vertices.push_back(static_cast<Index>(lines.vertex_count()));
      lines.positions.push_back(point);
    }
    if (curve.closed) {
      lines.positions.pop_back();
      vertices.back() = vertices.front();
    }
    lines.add_line(vertices);
    std::get<std::vector<std::int32_t>>(objects.data).push_back(static_cast<std::int32_t>(objects.labels.size()));
    objects.labels.push_back("chain " + std::to_string(objects.labels.size() + 1));
  }
  if (!curves.empty()) lines.channels.push_back(std::move(objects));
  return lines;
}

}  // namespace croquis
