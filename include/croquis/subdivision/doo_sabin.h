// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "croquis/base/progress.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// More faces than any computer draws without a pause, and about 2 GB.
inline constexpr std::size_t default_face_limit = 20'000'000;

/// How far to refine.
struct Depth {
  Depth(int wanted, std::size_t limit = default_face_limit) : levels(wanted), face_limit(limit) {}

  int levels;              ///< >= 0
  std::size_t face_limit;  ///< faces of the last level
};

/// Positions of all levels, kept between calls so that their memory is: dragging allocates nothing.
struct PositionBuffers {
  std::vector<std::vector<Vec3>> levels;  ///< [k] is #V of level k
};

/// Doo-Sabin refinement that keeps tagged edges sharp: everything that doesn't depend on positions.
///
/// Lee, Joo, Hong 2002, for all sets of tags on all oriented manifold cages. The connectivity of all levels and the
/// weights (each new point is a convex combination of old ones) depend on the cage's connectivity, its tags and the
/// rules alone; positions follow from them by `positions`, as often as points are dragged.
/// Immutable and cheap to copy; threads may share it.
class DooSabinPlan {
 public:
  /// Time and memory linear in the last level's faces (at most 100 bytes each).
  /// @throws Error (E_TOO_MANY_FACES) before anything is allocated, with the predicted counts; Cancelled
  DooSabinPlan(const Cage& cage, const Rules& rules, const Depth& depth, Progress& progress);

  const Rules& rules() const;
  int levels() const;  ///< the last one

  /// @param k 0 (the cage) … levels()
  const Level& level(int k) const;

  /// The points of all levels. The same bits for any number of threads.
  /// @param cage    #V of level 0; @param buffers resized where needed; @param threads >= 1
  /// @throws Error (E_INTERNAL) when the cage has another number of vertices
  void positions(std::span<const Vec3> cage, PositionBuffers& buffers, int threads = 1) const;

  /// The points of level k as weights of those of level k-1: rows sum to 1, none is negative.
  /// @param k 1 … levels()
  Eigen::SparseMatrix<double, Eigen::RowMajor> weights(int k) const;

  /// What an element of level k (1 …) was born from in level k-1.
  FaceOrigin face_origin(int k, Index face) const;
  VertexOrigin vertex_origin(int k, Index vertex) const;

  /// The vertex of the cage that a vertex of level k (0 …) descends from.
  Index cage_vertex(int k, Index vertex) const;

  /// The face, edge or vertex of the cage that a face of level k (1 …) descends from. Faces born from edges and
  /// vertices of a later level than the first count to their neighbour of the lowest number.
  FaceOrigin cage_element(int k, Index face) const;

  /// Whether the refinement to level k (1 …) put bands of faces beside some chain, to keep it from cutting through
  /// faces. With tags that are all infinite only the first can.
  bool banded(int k) const;

  /// Memory that the plan keeps for level k, in bytes; positions take 24 per vertex more.
  std::size_t bytes(int k) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace croquis::subdivision
