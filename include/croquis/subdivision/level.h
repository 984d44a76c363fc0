// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/subdivision/half_edges.h"

namespace croquis::subdivision {

struct SharpEdge {
  Index edge = no_index;
  double sharpness = 0;  ///< what is left of it: > 0, perhaps infinite_sharpness

  friend bool operator==(const SharpEdge&, const SharpEdge&) = default;
};

/// What a face was born from when its level was made.
enum class FaceKind : std::uint8_t { Face, Edge, Vertex, Band };

struct FaceOrigin {
  FaceKind kind = FaceKind::Face;
  Index element = no_index;  ///< of the level before: face, edge, vertex; the sharp edge beside which a band runs

  friend bool operator==(const FaceOrigin&, const FaceOrigin&) = default;
};

/// Which rule made a vertex.
enum class PointKind : std::uint8_t {
  Corner,  ///< of a face's corner (Doo-Sabin's own rule)
  Chain,   ///< of an end of a sharp edge
  Kept,    ///< of a vertex that stays
  Spoke    ///< of an unsharp edge that ends at a corner of the surface, beside a banded chain
};

struct VertexOrigin {
  PointKind kind = PointKind::Corner;
  Index vertex = no_index;   ///< of the level before: the one it stands for
  Index element = no_index;  ///< of the level before: corner, edge, vertex, edge

  friend bool operator==(const VertexOrigin&, const VertexOrigin&) = default;
};

/// The mesh of one level without its positions, and the tags that are left. Tags are sparse lists.
struct Level {
  HalfEdges topology;
  std::vector<SharpEdge> sharp;    ///< ascending by edge; never a boundary edge
  std::vector<Index> boundary;     ///< half-edges without twin, ascending
  std::vector<Index> pins;         ///< vertices that stay as long as sharp edges meet there; ascending
  std::vector<Index> settled;      ///< vertices kept by the refinement that made this level; ascending
  std::vector<Index> valence_two;  ///< vertices inside with only two faces; ascending
};

}  // namespace croquis::subdivision
