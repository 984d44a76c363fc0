// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/tag_classes.h"

#include <algorithm>

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

}  // namespace croquis::subdivision
