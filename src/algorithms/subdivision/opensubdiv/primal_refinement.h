// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/vector.h"

/// The one place that speaks to OpenSubdiv: topology in, topology and stencils out, as plain arrays.
namespace croquis::subdivision {

enum class PrimalScheme { CatmullClark, Loop };

/// What OpenSubdiv refines. Faces are counter-clockwise; each edge has one or two of them, each vertex one fan.
struct PrimalTopology {
  PrimalScheme scheme = PrimalScheme::CatmullClark;
  bool corners_stay = true;       ///< boundary vertices of one face keep their place
  std::size_t vertex_count = 0;   ///< #V
  std::vector<Index> face_sizes;  ///< #F
  std::vector<Index> corners;     ///< #C
  std::vector<Crease> creases;    ///< never on the boundary
  std::vector<Index> pins;
};

/// Rows of weights: value i = sum of weights times the values at columns, over [offsets[i], offsets[i+1]).
struct WeightRows {
  std::vector<Index> offsets = {0};
  std::vector<Index> columns;
  std::vector<double> weights;

  std::size_t size() const { return offsets.size() - 1; }
};

struct PrimalLevel {
  std::size_t vertex_count = 0;
  std::vector<Index> face_sizes, corners;
  std::vector<Crease> creases;      ///< edges still sharp, without the boundary; sharpness of this level
  std::vector<Index> pins;          ///< descendants of the pins
  std::vector<Index> face_parents;  ///< #F, faces of the level before
  WeightRows rows;                  ///< #V, over the vertices of the level before
};

/// Levels 1 to the last, and where the last level's vertices end: weights over the last level's vertices.
struct PrimalRefinement {
  std::vector<PrimalLevel> levels;
  WeightRows limit, first_tangent, second_tangent;
};

/// @param levels 0 … 15
/// @throws Error (E_SUBDIVISION) with OpenSubdiv's own message, e.g. for more than 65535 edges at one vertex
PrimalRefinement refine(const PrimalTopology& topology, int levels, Progress& progress);

}  // namespace croquis::subdivision
