// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/vector.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A segment of a figure in the direction of its contour.
struct DirectedSegment {
  Index contour = 0;
  Index position = 0;  ///< in the contour's vertices
  Index begin = 0;     ///< points
  Index end = 0;
  int side = 1;   ///< +1: the surface lies on its left
  int depth = 0;  ///< surfaces in front
};

/// One per entry of LabelledFigure::segments.
std::vector<DirectedSegment> directed_segments(const LabelledFigure& figure);

/// The immersed region M: w copies of every planar triangle, joined across its edges by the paneling.
///
/// Layer 0 is nearest to the viewer. All layers share one planar triangulation, so edges conform by construction.
struct LiftedTriangulation {
  std::vector<Index> first_copy;  ///< #T+1: the copies of planar triangle t are first_copy[t] … in layer order
  /// #M by 3 lifted vertices, corners in the planar triangle's order.
  std::vector<std::array<Index, 3>> triangles;
  /// #M by 3, across the edge opposite to corner i; no_index on the boundary.
  std::vector<std::array<Index, 3>> neighbours;
  std::vector<Index> planar_triangle;     ///< #M
  std::vector<Index> planar_vertex;       ///< per lifted vertex: its point
  std::vector<std::uint8_t> on_boundary;  ///< per lifted vertex

  Index layer_of(Index triangle) const { return triangle - first_copy[planar_triangle[triangle]]; }
};

/// Makes the copies and glues them: across a plain edge layer i to layer i; across a contour segment of depth n from
/// the side with more layers, (F,i) to (F',i) for i < n and to (F',i-1) for i > n, while (F,n) ends there.
///
/// A lifted vertex is a set of corners that meet across glued edges: where several sheets lie above one point, each has
/// a vertex of its own. Vertices are numbered in the order of the triangles that first use them. O(M).
/// @param layers           #T, number of copies
/// @param constraint_depth per constraint of the triangulation: n, or negative for an edge that is no contour
/// @throws Error (E_INTERNAL) when the numbers of layers on the two sides of a contour segment don't differ by one, of
///         a plain edge differ at all, or the sheets around a point don't close
LiftedTriangulation lift(const PlanarTriangulation& planar, std::span<const int> layers,
                         std::span<const int> constraint_depth);

/// The immersed region of a labelled figure.
LiftedTriangulation lift(const LabelledFigure& figure);

/// The lifted vertex of every contour point: per contour, one per position.
/// @throws Error (E_INTERNAL) when the boundary of the region doesn't follow the contours: contradicting depths around
///         a crossing make it turn off there
std::vector<std::vector<Index>> contour_vertices(const LabelledFigure& figure, const LiftedTriangulation& lifted);

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
