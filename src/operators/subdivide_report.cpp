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

Report chain_entry(const EdgeChain& chain, const ChainShape& shape, const std::vector<CageEdge>& origins) {
  Report ends = Report::array();
  if (!chain.closed) {
    for (const ChainEnd end : chain.ends) ends.push(name_of(end));
  }
  Report cage_edges = Report::array();
  for (const CageEdge& edge : origins) cage_edges.push(Report::list(edge));
  Report entry;
  entry.set("edges", chain.edges.size())
      .set("closed", chain.closed)
      .set("ends", std::move(ends))
      .set("dihedral_min", shape.least_bend * degrees)
      .set("dihedral_max", shape.greatest_bend * degrees)
      .set("side_max", Report::list(std::vector<double>{shape.side_bends[0] * degrees, shape.side_bends[1] * degrees}))
      .set("length", shape.length)
      .set("planar", shape.planar())
      .set("deviation", shape.deviation)
      .set("cage_edges", std::move(cage_edges));
  return entry;
}

}  // namespace

Report level_counts(const SubdivisionPlan& plan, int last) {
  Report list = Report::array();
  for (int k = 0; k <= last; ++k) {
    const Level& level = level_of(plan, k);
    Report counts;
    counts.set("vertices", level.topology.vertex_count())
        .set("edges", level.topology.edge_count())
        .set("faces", level.topology.face_count())
        .set("boundary_edges", level.boundary.size())
        .set("sharp_edges", level.sharp.size());
    list.push(std::move(counts));
  }
  return list;
}

Report chain_list(const Level& level, std::span<const EdgeChain> chains, std::span<const Vec3> positions,
                  std::span<const std::vector<CageEdge>> origins) {
  const std::vector<ChainShape> shapes = chain_shapes(level, chains, positions);
  Report list = Report::array();
  for (std::size_t i = 0; i < chains.size(); ++i) list.push(chain_entry(chains[i], shapes[i], origins[i]));
  return list;
}

Report continuity_list(const ContinuityReport& report, int last) {
  Report list = Report::array();
  for (std::size_t k = 0; k <= static_cast<std::size_t>(last); ++k) list.push(report.levels[k].greatest_bend * degrees);
  return list;
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
