// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

/// Memory for arrays that are written once and read often: large blocks ask the system for large pages, since half the
/// time of making a level goes into the first touch of small ones.
/// @throws std::bad_alloc
void* allocate_block(std::size_t bytes);
void free_block(void* block);

/// Leaves new elements unset where a vector would zero them: arrays of a level are written by one pass right after
/// they got their size, and touching their memory twice costs as much as computing it.
template <typename T>
struct UnsetAllocator {
  using value_type = T;

  UnsetAllocator() = default;
  template <typename U>
  UnsetAllocator(const UnsetAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_block(count * sizeof(T))); }
  void deallocate(T* block, std::size_t) { free_block(block); }

  template <typename U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const UnsetAllocator&, const UnsetAllocator&) { return true; }
};

/// A vector of indices whose resize() leaves new elements unset.
using IndexArray = std::vector<Index, UnsetAllocator<Index>>;

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
