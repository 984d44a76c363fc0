// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/level_bytes.h"

namespace croquis::subdivision {
namespace {

template <typename... Arrays>
std::size_t array_bytes(const Arrays&... arrays) {
  return (... + (arrays.capacity() * sizeof(arrays[0])));
}

std::size_t rows_bytes(const WeightRows& rows) { return array_bytes(rows.offsets, rows.columns, rows.weights); }

}  // namespace

std::size_t bytes_of(const Level& level) {
  const HalfEdges& mesh = level.topology;
  return sizeof(Level) +
         array_bytes(mesh.face_offsets, mesh.corner_vertex, mesh.twin, mesh.corner_edge, mesh.edge_corner,
                     mesh.vertex_corner) +
         array_bytes(level.sharp, level.boundary, level.pins, level.settled, level.valence_two);
}

std::size_t bytes_of(const Refinement& refinement) {
  const PointRules& rules = refinement.rules;
  const LevelOrigins& origins = refinement.origins;
  return bytes_of(refinement.level) + sizeof(Refinement) - sizeof(Level) +
         array_bytes(rules.gap_faces, rules.adjusted_corner, rules.plain_share) + rows_bytes(rules.adjusted) +
         rows_bytes(rules.listed) +
         array_bytes(origins.own_corners.left_out(), origins.listed, origins.plain_vertices.left_out(),
                     origins.listed_faces);
}

}  // namespace croquis::subdivision
