// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/new_points.h"

#include <algorithm>
#include <numeric>

namespace croquis::subdivision {
namespace {

/// Corners of unbanded sectors at which their faces take a point of the chain.
std::vector<Index> replaced_corners(const Sectors& sectors) {
  std::vector<Index> replaced;
  for (const Sector& sector : sectors.list) {
    if (sector.banded) continue;
    replaced.push_back(sectors.corners[sector.begin]);
    replaced.push_back(sectors.corners[sector.end - 1]);
  }
  return replaced;
}

}  // namespace

NewPoints::NewPoints(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors)
    : own_(replaced_corners(sectors), mesh.corner_count()) {
  list_kept(classes);
  list_chain_ends(classes, sectors);
  list_spokes(mesh, classes, sectors);
  list_corner_points(mesh, classes, sectors);
}

Index NewPoints::find(const Table& table, Index element) {
  const auto found = std::lower_bound(table.begin(), table.end(), std::pair(element, Index{0}));
  return found != table.end() && found->first == element ? found->second : no_index;
}

Index NewPoints::list_point(const VertexOrigin& origin) {
  listed_.push_back(origin);
  return static_cast<Index>(count() - 1);
}

void NewPoints::list_kept(const TagClasses& classes) {
  for (const Index vertex : classes.special) {
    if (classes.class_of[vertex] != VertexClass::Corner) continue;
    kept_.emplace_back(vertex, list_point({PointKind::Kept, vertex, vertex}));
  }
}

void NewPoints::list_chain_ends(const TagClasses& classes, const Sectors& sectors) {
  chain_.resize(classes.lines.size());
  for (Index line = 0; line < classes.lines.size(); ++line) {
    const bool banded = sectors.side_banded[2 * line] || sectors.side_banded[2 * line + 1];
    for (std::size_t end = 0; end < 2; ++end) {
      const Index vertex = classes.lines[line].vertices[end];
      chain_[line][end] = !banded && classes.class_of[vertex] == VertexClass::Corner
                              ? kept(vertex)
                              : list_point({PointKind::Chain, vertex, classes.lines[line].edge});
    }
  }
}

void NewPoints::list_spokes(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors) {
  for (const Sector& sector : sectors.list) {
    if (!sector.banded || classes.class_of[sector.vertex] != VertexClass::Corner) continue;
    for (Index i = sector.begin + 1; i < sector.end; ++i) {
      const Index half_edge = sectors.corners[i];
      spokes_.emplace_back(half_edge, list_point({PointKind::Spoke, sector.vertex, mesh.corner_edge[half_edge]}));
    }
  }
  std::sort(spokes_.begin(), spokes_.end());
}

void NewPoints::list_corner_points(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors) {
  if (own_.left_out().empty()) return;
  points_.resize(mesh.corner_count());
  own_.for_each_run([&](Index begin, Index end, Index first_point) {
    std::iota(points_.begin() + begin, points_.begin() + end, first_point);
  });
  for (const Sector& sector : sectors.list) {
    if (sector.banded) continue;
    // With a single face both are the same corner, of a surface's corner, and both points the kept one.
    points_[sectors.corners[sector.begin]] = chain_at(classes, sector.first_line, sector.vertex);
    points_[sectors.corners[sector.end - 1]] = chain_at(classes, sector.last_line, sector.vertex);
  }
}

}  // namespace croquis::subdivision
