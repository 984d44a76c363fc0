// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/mesh_editing/mesh_selection.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace croquis {
namespace {

/// Which elements are in a list: one byte each.
std::vector<char> marked(std::span<const Index> elements, std::size_t count) {
  std::vector<char> marks(count, 0);
  for (const Index element : elements) {
    if (element < count) marks[element] = 1;
  }
  return marks;
}

Elements listed(const std::vector<char>& marks) {
  Elements elements;
  for (Index i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) elements.push_back(i);
  }
  return elements;
}

/// Calls for each corner of a face.
template <typename Visit>
void for_corners_of(const MeshTopology& topology, Index first_corner, Visit visit) {
  Index corner = first_corner;
  do {
    visit(corner);
    corner = topology.next(corner);
  } while (corner != first_corner);
}

/// The vertices of elements, as marks.
std::vector<char> vertices_of(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements) {
  const std::size_t count = element_count(topology, kind);
  if (kind == ComponentKind::Vertex) return marked(elements, count);
  std::vector<char> vertices(topology.vertex_count(), 0);
  if (kind == ComponentKind::Edge) {
    for (const Index edge : elements) {
      if (edge >= count) continue;
      for (const Index vertex : topology.edge_vertices(edge)) vertices[vertex] = 1;
    }
    return vertices;
  }
  const std::vector<char> faces = marked(elements, count);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (faces[topology.face(corner)] != 0) vertices[topology.vertex(corner)] = 1;
  }
  return vertices;
}

/// Elements of which one vertex (or all of them) is marked.
std::vector<char> with_vertices(const MeshTopology& topology, ComponentKind kind, std::vector<char> vertices,
                                bool all) {
  if (kind == ComponentKind::Vertex) return vertices;
  std::vector<char> marks(element_count(topology, kind), all ? 1 : 0);
  if (kind == ComponentKind::Edge) {
    for (Index edge = 0; edge < marks.size(); ++edge) {
      const auto [a, b] = topology.edge_vertices(edge);
      marks[edge] = all ? vertices[a] & vertices[b] : vertices[a] | vertices[b];
    }
    return marks;
  }
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if ((vertices[topology.vertex(corner)] != 0) != all) marks[topology.face(corner)] = all ? 0 : 1;
  }
  return marks;
}

/// The edges of marked faces, as marks.
std::vector<char> edges_of_faces(const MeshTopology& topology, const std::vector<char>& faces) {
  std::vector<char> edges(topology.edge_count(), 0);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (faces[topology.face(corner)] != 0 && topology.edge(corner) != no_index) edges[topology.edge(corner)] = 1;
  }
  return edges;
}

/// Faces of which one edge (or all of them) is marked.
std::vector<char> faces_with_edges(const MeshTopology& topology, const std::vector<char>& edges, bool all) {
  std::vector<char> faces(topology.face_count(), all ? 1 : 0);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    const Index edge = topology.edge(corner);
    if (edge != no_index && (edges[edge] != 0) != all) faces[topology.face(corner)] = all ? 0 : 1;
  }
  return faces;
}

std::vector<char> flipped(std::vector<char> marks) {
  for (char& mark : marks) mark = mark != 0 ? 0 : 1;
  return marks;
}

/// Marks with everything that shares a vertex with something marked.
std::vector<char> grown_marks(const MeshTopology& topology, ComponentKind kind, const std::vector<char>& marks) {
  if (kind != ComponentKind::Vertex)
    return with_vertices(topology, kind, vertices_of(topology, kind, listed(marks)), false);
  // Vertices grow along edges, not across faces.
  std::vector<char> more = marks;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto [a, b] = topology.edge_vertices(edge);
    if ((marks[a] | marks[b]) != 0) more[a] = more[b] = 1;
  }
  return more;
}

}  // namespace

// ---- Lists

std::size_t element_count(const MeshTopology& topology, ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return topology.vertex_count();
  return kind == ComponentKind::Edge ? topology.edge_count() : topology.face_count();
}

Elements sorted_unique(Elements elements) {
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

Elements united(std::span<const Index> a, std::span<const Index> b) {
  Elements result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Elements subtracted(std::span<const Index> from, std::span<const Index> what) {
  Elements result;
  std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(result));
  return result;
}

Elements toggled(std::span<const Index> a, std::span<const Index> b) {
  Elements result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Elements all_elements(std::size_t count) {
  Elements elements(count);
  std::iota(elements.begin(), elements.end(), Index{0});
  return elements;
}

Elements inverted(std::span<const Index> sorted, std::size_t count) { return listed(flipped(marked(sorted, count))); }

// ---- Areas

Elements grown(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements) {
  return listed(grown_marks(topology, kind, marked(elements, element_count(topology, kind))));
}

Elements shrunk(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements) {
  const std::vector<char> others = flipped(marked(elements, element_count(topology, kind)));
  return listed(flipped(grown_marks(topology, kind, others)));
}

Elements connected(const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements) {
  const std::vector<char> vertices = vertices_of(topology, kind, elements);
  std::vector<char> components(topology.component_count(), 0);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (vertices[topology.vertex(corner)] != 0) components[topology.component(topology.face(corner))] = 1;
  }
  std::vector<char> reached = vertices;  // with vertices that have no faces
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (components[topology.component(topology.face(corner))] != 0) reached[topology.vertex(corner)] = 1;
  }
  return listed(with_vertices(topology, kind, std::move(reached), true));
}

Elements converted(const MeshTopology& topology, ComponentKind from, ComponentKind to, std::span<const Index> elements,
                   ConvertRule rule) {
  const bool all = rule == ConvertRule::Contained;
  const std::size_t count = element_count(topology, from);
  if (from == to) return listed(marked(elements, count));
  if (from == ComponentKind::Face && to == ComponentKind::Edge)
    return listed(edges_of_faces(topology, marked(elements, count)));
  if (from == ComponentKind::Edge && to == ComponentKind::Face)
    return listed(faces_with_edges(topology, marked(elements, count), all));
  return listed(with_vertices(topology, to, vertices_of(topology, from, elements), all));
}

Elements boundary_edges(const MeshTopology& topology) {
  Elements edges;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() == 1) edges.push_back(edge);
  }
  return edges;
}

}  // namespace croquis
