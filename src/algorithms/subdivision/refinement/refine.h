// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/SparseCore>

#include "algorithms/subdivision/refinement/point_rules.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/base/progress.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// Where the elements of a level come from; what follows from numbers isn't stored.
struct LevelOrigins {
  Compaction own_corners;            ///< old corners with a point of their own
  std::vector<VertexOrigin> listed;  ///< the points behind those
  Index old_faces = 0;
  Index quads = 0;                       ///< faces behind those of old faces, from plain edges
  Index quads_begin = 0;                 ///< their first corner
  Compaction plain_vertices;             ///< of which the faces behind the quads are
  std::vector<FaceOrigin> listed_faces;  ///< the last faces

  /// @param old the level before; @param made the one these origins are of
  FaceOrigin face(Index face, const HalfEdges& old, const HalfEdges& made) const;
  VertexOrigin vertex(Index vertex, const HalfEdges& old) const;
};

/// A level and how it follows from the one before.
struct Refinement {
  Level level;
  PointRules rules;
  LevelOrigins origins;
  bool banded = false;
};

/// One step of refinement, in time linear in the new level; the tagged neighbourhood's share n takes n log n.
Refinement refine(const Level& old, const Rules& rules, const FaceMask& mask, FlatScratch& scratch,
                  const Progress& progress);

/// The size of a large page on the machines we build for.
inline constexpr std::size_t large_page = std::size_t{2} << 20;

/// Asks the system for large pages in memory that is still untouched; where it refuses pages are small.
void request_large_pages(void* block, std::size_t bytes);

/// The points of a level from those of the level before.
/// @param old_points #V of `old`; @param points #V of `made`
void compute_positions(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* old_points,
                       Vec3* points, int threads);

/// What compute_positions does, as a matrix of #V of the new level by #V of the old.
Eigen::SparseMatrix<double, Eigen::RowMajor> level_weights(const HalfEdges& old, const Refinement& made,
                                                           const FaceMask& mask);

/// Memory held by their arrays.
std::size_t bytes_of(const Level& level);
std::size_t bytes_of(const Refinement& refinement);

}  // namespace croquis::subdivision
