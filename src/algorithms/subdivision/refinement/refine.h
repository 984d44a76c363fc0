// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

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

}  // namespace croquis::subdivision
