// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/mesh_tags.h"

namespace croquis::subdivision {
namespace {

SharpLine line_at(const HalfEdges& mesh, const CornerFaces& around, Index half_edge, double sharpness) {
  return {mesh.corner_edge[half_edge],
          {half_edge, mesh.twin[half_edge]},
          {mesh.corner_vertex[half_edge], mesh.corner_vertex[around.next(half_edge)]},
          sharpness};
}

std::vector<SharpLine> find_lines(const Level& level, const CornerFaces& around) {
  const HalfEdges& mesh = level.topology;
  std::vector<SharpLine> lines;
  for (const auto& [edge, sharpness] : level.sharp) {
    if (sharpness >= 1) lines.push_back(line_at(mesh, around, mesh.edge_corner[edge], sharpness));
  }
  for (const Index half_edge : level.boundary) {
    lines.push_back(line_at(mesh, around, half_edge, infinite_sharpness));
  }
  return lines;
}

bool has_one_face(const HalfEdges& mesh, const CornerFaces& around, Index vertex) {
  const Index start = mesh.vertex_corner[vertex];
  return mesh.twin[start] == no_index && mesh.twin[around.previous(start)] == no_index;
}

VertexClass class_by_count(std::size_t sharp_edges) {
  if (sharp_edges == 0) return VertexClass::ValenceTwo;
  if (sharp_edges == 1) return VertexClass::Dart;
  return sharp_edges == 2 ? VertexClass::Crease : VertexClass::Corner;
}

Index side_of(const TagClasses& classes, const HalfEdges& mesh, Index half_edge) {
  const Index line = classes.line_of_edge[mesh.corner_edge[half_edge]];
  return 2 * line + (classes.lines[line].half_edges[0] == half_edge ? 0 : 1);
}

/// A corner of the vertex that starts a sharp edge; on the boundary the first of the fan.
Index first_sharp_corner(const HalfEdges& mesh, const CornerFaces& around, const TagClasses& classes, Index vertex) {
  Index corner = mesh.vertex_corner[vertex];
  while (!classes.sharp(mesh.corner_edge[corner])) corner = mesh.twin[around.previous(corner)];
  return corner;
}

void add_sectors(const HalfEdges& mesh, const CornerFaces& around, const TagClasses& classes, Index vertex,
                 Sectors& sectors) {
  const Index start = first_sharp_corner(mesh, around, classes, vertex);
  Index corner = start;
  do {
    Sector sector;
    sector.vertex = vertex;
    sector.begin = static_cast<Index>(sectors.corners.size());
    sector.first_side = side_of(classes, mesh, corner);
    for (;;) {
      sectors.corners.push_back(corner);
      const Index arriving = around.previous(corner);
      corner = mesh.twin[arriving];
      if (!classes.sharp(mesh.corner_edge[arriving])) continue;
      sector.last_side = side_of(classes, mesh, arriving);
      break;
    }
    sector.end = static_cast<Index>(sectors.corners.size());
    sector.first_line = sector.first_side / 2;
    sector.last_line = sector.last_side / 2;
    sectors.list.push_back(sector);
  } while (corner != no_index && corner != start);
}

/// Whether this sector would cut or enlarge faces without a band.
bool is_irregular(const Sector& sector, VertexClass vertex_class, bool settled) {
  switch (vertex_class) {
    case VertexClass::Dart: return sector.face_count() < 3;
    case VertexClass::Crease: return sector.face_count() != 2;
    case VertexClass::Corner: return sector.face_count() != 1 && !settled;
    default: return false;
  }
}

bool joins_corner_and_dart(const SharpLine& line, const TagClasses& classes) {
  const auto [a, b] = std::minmax(classes.class_of[line.vertices[0]], classes.class_of[line.vertices[1]]);
  return a == VertexClass::Dart && b == VertexClass::Corner;
}

void band_irregular_strips(const Level& level, const TagClasses& classes, Sectors& sectors) {
  const auto side_count = static_cast<Index>(2 * classes.lines.size());
  DisjointSets strips(side_count);
  for (const Sector& sector : sectors.list) {
    strips.unite(sector.first_side, sector.last_side);
    if (classes.class_of[sector.vertex] != VertexClass::Corner) continue;
    for (const Index line : {sector.first_line, sector.last_line}) strips.unite(2 * line, 2 * line + 1);
  }
  std::vector<bool> irregular(side_count);
  for (const Sector& sector : sectors.list) {
    const bool settled = std::binary_search(level.settled.begin(), level.settled.end(), sector.vertex);
    if (is_irregular(sector, classes.class_of[sector.vertex], settled)) {
      irregular[strips.root(sector.first_side)] = true;
    }
  }
  for (Index line = 0; line < classes.lines.size(); ++line) {
    if (!joins_corner_and_dart(classes.lines[line], classes)) continue;
    irregular[strips.root(2 * line)] = irregular[strips.root(2 * line + 1)] = true;
  }
  sectors.side_banded.resize(side_count);
  for (Index side = 0; side < side_count; ++side) sectors.side_banded[side] = irregular[strips.root(side)];
  for (Sector& sector : sectors.list) sector.banded = sectors.side_banded[sector.first_side];
}

}  // namespace

TagClasses classify(const Level& level, const CornerFaces& around, const Rules& rules) {
  const HalfEdges& mesh = level.topology;
  TagClasses classes;
  classes.lines = find_lines(level, around);
  classes.line_of_edge.assign(mesh.edge_count(), no_index);
  std::vector<Index> ends;
  for (Index line = 0; line < classes.lines.size(); ++line) {
    classes.line_of_edge[classes.lines[line].edge] = line;
    for (const Index vertex : classes.lines[line].vertices) ends.push_back(vertex);
  }
  ends.insert(ends.end(), level.valence_two.begin(), level.valence_two.end());
  std::sort(ends.begin(), ends.end());

  classes.pinned.assign(mesh.vertex_count(), 0);
  for (const Index vertex : level.pins) classes.pinned[vertex] = 1;
  classes.class_of.assign(mesh.vertex_count(), VertexClass::Plain);
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    const Index vertex = ends[begin];
    while (end < ends.size() && ends[end] == vertex) ++end;
    const bool thin = std::binary_search(level.valence_two.begin(), level.valence_two.end(), vertex);
    VertexClass& found = classes.class_of[vertex] = class_by_count(end - begin - (thin ? 1 : 0));
    if (found == VertexClass::Crease &&
        (classes.pinned[vertex] != 0 ||
         (rules.boundary_corners == BoundaryCorners::Corner && has_one_face(mesh, around, vertex)))) {
      found = VertexClass::Corner;
    }
    classes.special.push_back(vertex);
  }
  return classes;
}

bool Sectors::any_banded() const {
  return std::find(side_banded.begin(), side_banded.end(), true) != side_banded.end();
}

Sectors find_sectors(const Level& level, const CornerFaces& around, const TagClasses& classes) {
  Sectors sectors;
  for (const Index vertex : classes.special) {
    if (classes.class_of[vertex] != VertexClass::ValenceTwo) {
      add_sectors(level.topology, around, classes, vertex, sectors);
    }
  }
  band_irregular_strips(level, classes, sectors);
  return sectors;
}

}  // namespace croquis::subdivision
