// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivide_report.h"

#include <numbers>
#include <string>
#include <utility>

namespace croquis {
namespace {

using namespace subdivision;

constexpr double degrees = 180 / std::numbers::pi;

const char* name_of(ChainEnd end) { return end == ChainEnd::Corner ? "corner" : "dart"; }

Report chain_entry(const SharpChain& chain) {
  Report ends = Report::array();
  if (!chain.closed) {
    for (const ChainEnd end : chain.ends) ends.push(name_of(end));
  }
  Report cage_edges = Report::array();
  for (const CageEdge& edge : chain.cage_edges) cage_edges.push(Report::list(edge));
  const std::vector<double> sides{chain.side_angles[0] * degrees, chain.side_angles[1] * degrees};
  Report entry;
  entry.set("edges", chain.edges)
      .set("closed", chain.closed)
      .set("ends", std::move(ends))
      .set("dihedral_min", chain.least_angle * degrees)
      .set("dihedral_max", chain.greatest_angle * degrees)
      .set("side_max", Report::list(sides))
      .set("length", chain.length)
      .set("planar", chain.planar)
      .set("deviation", chain.deviation)
      .set("cage_edges", std::move(cage_edges));
  return entry;
}

Report level_entry(const LevelCounts& counts) {
  Report entry;
  return std::move(entry.set("vertices", counts.vertices)
                       .set("edges", counts.edges)
                       .set("faces", counts.faces)
                       .set("boundary_edges", counts.boundary_edges)
                       .set("sharp_edges", counts.sharp_edges));
}

}  // namespace

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

std::vector<double> continuity_angles(const ContinuityReport& report, int last) {
  std::vector<double> angles;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(last); ++k) angles.push_back(report.levels[k].greatest_bend);
  return angles;
}

Report to_report(const SubdivideResult& result) {
  Report levels = Report::array();
  for (const LevelCounts& counts : result.levels) levels.push(level_entry(counts));
  Report details;
  details.set("scheme", to_string(result.scheme)).set("levels", std::move(levels));
  if (!result.judged) return details;
  Report chains = Report::array();
  for (const SharpChain& chain : result.chains) chains.push(chain_entry(chain));
  Report continuity = Report::array();
  for (const double angle : result.continuity) continuity.push(angle * degrees);
  return std::move(
      details.set("chains", std::move(chains)).set("continuity", std::move(continuity)).set("verdict", result.verdict));
}

std::size_t byte_size(const SubdivideResult& result) {
  std::size_t bytes = sizeof(SubdivideResult) + result.levels.capacity() * sizeof(LevelCounts) +
                      result.chains.capacity() * sizeof(SharpChain) + result.continuity.capacity() * sizeof(double) +
                      result.verdict.capacity();
  for (const SharpChain& chain : result.chains) bytes += chain.cage_edges.capacity() * sizeof(CageEdge);
  return bytes;
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
