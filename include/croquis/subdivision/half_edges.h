// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "croquis/subdivision/index_array.h"

namespace croquis::subdivision {

/// The connectivity of an oriented 2-manifold with or without boundary: every vertex has exactly one fan of faces.
///
/// Flat arrays of 32-bit indices. A corner is a vertex in one of its faces, and stands for the half-edge that leaves
/// that vertex counter-clockwise around the face. Faces have 3 or more corners.
struct HalfEdges {
  IndexArray face_offsets{0};  ///< #F+1: face f has corners [face_offsets[f], face_offsets[f+1])
  IndexArray corner_vertex;    ///< #C
  IndexArray twin;             ///< #C, the half-edge the other way; no_index on the boundary
  IndexArray corner_edge;      ///< #C
  IndexArray edge_corner;      ///< #E, one half-edge of the edge; the boundary's only one
  IndexArray vertex_corner;    ///< #V, from which turning counter-clockwise (`twin` of the corner before) reaches all

  std::size_t vertex_count() const { return vertex_corner.size(); }
  std::size_t edge_count() const { return edge_corner.size(); }
  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::size_t corner_count() const { return corner_vertex.size(); }

  std::span<const Index> face(std::size_t f) const {
    return {corner_vertex.data() + face_offsets[f], corner_vertex.data() + face_offsets[f + 1]};
  }
};

/// The faces of all corners, for walks that turn around vertices; not kept with the mesh since it costs as much as the
/// corners themselves. Linear time.
class CornerFaces {
 public:
  CornerFaces() = default;  ///< of no corner
  explicit CornerFaces(const HalfEdges& mesh);

  Index face(Index corner) const { return face_[corner]; }
  Index next(Index corner) const {
    const Index face = face_[corner];
    return corner + 1 == offsets_[face + std::size_t{1}] ? offsets_[face] : corner + 1;
  }
  Index previous(Index corner) const {
    const Index face = face_[corner];
    return corner == offsets_[face] ? offsets_[face + std::size_t{1}] - 1 : corner - 1;
  }

 private:
  IndexArray face_;
  const Index* offsets_ = nullptr;  ///< of the mesh, which has to outlive this
};

}  // namespace croquis::subdivision
