// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "algorithms/silhouette/skeleton/immersion.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The Delaunay triangulation of the immersed region over its contour points alone.
///
/// Its vertices are the contours' points, in order: vertex first_vertex[c] + i is the point at position i of contour c.
struct ImmersedTriangulation {
  std::vector<std::array<Index, 3>> triangles;   ///< #F by 3, counter-clockwise in the plane
  std::vector<std::array<Index, 3>> neighbours;  ///< #F by 3, across the edge opposite to corner i, or no_index
  std::vector<Index> first_vertex;               ///< #contours + 1
  std::vector<Index> planar_vertex;              ///< #V, index into the figure's points
  std::vector<Index> lifted_vertex;              ///< #V, the same place in the lifted triangulation
};

/// Takes the interior vertices (samples and crossings of contours that pass above or below a sheet) out of the lifted
/// triangulation, then flips edges until every one is locally Delaunay (Lawson 1977). Stands in for Cordier and
/// Cheong's unpublished algorithm that Cordier, Seo, Cho 2006, section 4.1 uses.
///
/// Plane coordinates suffice, since the immersion keeps lengths; every decision is exact. Edges with four points on one
/// circle stay as they are. Near-linear in practice.
/// @throws Error (E_INTERNAL) when the region isn't a surface bounded by the contours; Cancelled
ImmersedTriangulation immerse(const LabelledFigure& figure, const LiftedTriangulation& lifted, Progress& progress);

}  // namespace croquis::silhouette
