// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/poly_mesh.h"

#include <array>

namespace croquis {

std::size_t AttributeChannel::size() const {
  return std::visit([](const auto& values) { return values.size(); }, data);
}

void PolyMesh::add_face(std::span<const Index> vertices) {
  corners.insert(corners.end(), vertices.begin(), vertices.end());
  face_offsets.push_back(static_cast<Index>(corners.size()));
}

void PolyMesh::add_triangle(Index a, Index b, Index c) { add_face(std::array{a, b, c}); }

void PolyMesh::add_line(std::span<const Index> vertices) {
  line_vertices.insert(line_vertices.end(), vertices.begin(), vertices.end());
  line_offsets.push_back(static_cast<Index>(line_vertices.size()));
}

std::size_t PolyMesh::element_count(Domain domain) const {
  switch (domain) {
    case Domain::Vertex: return vertex_count();
    case Domain::Face: return face_count();
    case Domain::Corner: return corners.size();
    case Domain::Line: return line_count();
  }
  return 0;
}

const AttributeChannel* PolyMesh::channel(std::string_view name, Domain domain) const {
  for (const AttributeChannel& candidate : channels) {
    if (candidate.name == name && candidate.domain == domain) return &candidate;
  }
  return nullptr;
}

AttributeChannel* PolyMesh::channel(std::string_view name, Domain domain) {
  return const_cast<AttributeChannel*>(static_cast<const PolyMesh*>(this)->channel(name, domain));
}

}  // namespace croquis
