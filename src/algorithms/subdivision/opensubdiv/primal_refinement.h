// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/uniform_schemes.h"

/// The only code that uses OpenSubdiv: topology in, topology and stencils out, as plain arrays.
namespace croquis::subdivision {

/// What OpenSubdiv refines. Faces are counter-clockwise; each edge has one or two of them, each vertex one fan.
struct PrimalTopology {
  UniformRules rules;
  std::size_t vertex_count = 0;   ///< #V
  std::vector<Index> face_sizes;  ///< #F
  std::vector<Index> corners;     ///< #C
  std::vector<Crease> creases;    ///< never on the boundary
  std::vector<Index> pins;
};

/// A level as it is.
PrimalTopology primal_topology(const Level& level, const UniformRules& rules);

struct PrimalLevel {
  Level level;
  std::vector<Index> face_parents;  ///< #F, faces of the level before; empty for level 0
  WeightRows rows;                  ///< #V over the vertices of the level before; empty for level 0
};

/// Levels 0 to the last. Level 0 has OpenSubdiv's own numbers of edges.
/// @param topology at least one face
/// @param levels   0 … 15
/// @throws Error (E_SUBDIVISION) with OpenSubdiv's own message, e.g. for more than 65535 edges at one vertex
std::vector<PrimalLevel> refine(const PrimalTopology& topology, int levels, Progress& progress);

/// Where the vertices of a mesh end, and two tangents there, as weights over the mesh's vertices. At boundaries the
/// tangents are those of the one side, the first along the boundary.
struct PrimalLimit {
  WeightRows points, first_tangent, second_tangent;
};

/// @throws Error (E_SUBDIVISION) as refine
PrimalLimit limit(const PrimalTopology& topology, Progress& progress);

}  // namespace croquis::subdivision
