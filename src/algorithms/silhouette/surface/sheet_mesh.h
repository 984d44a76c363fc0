// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/shell.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// How far the front and the back of a sheet may each be moved up or down, sketch units.
struct SheetClearance {
  double front = std::numeric_limits<double>::infinity();
  double back = std::numeric_limits<double>::infinity();

  double least() const { return std::min(front, back); }
};

/// The less of both, for the front and for the back.
inline SheetClearance common_clearance(const SheetClearance& a, const SheetClearance& b) {
  return {std::min(a.front, b.front), std::min(a.back, b.back)};
}

/// All sheets of a figure as a mesh of the immersed region, each sheet with triangles of its own: a front z + h and a
/// back z - h over every vertex.
struct SheetMesh {
  std::vector<Vec2> place;                       ///< #V
  std::vector<double> z;                         ///< #V
  std::vector<double> thickness;                 ///< #V, h: 0 exactly on the boundary
  std::vector<std::uint8_t> on_boundary;         ///< #V
  std::vector<std::array<Index, 3>> triangles;   ///< #M by 3, counter-clockwise in the plane
  std::vector<std::array<Index, 3>> neighbours;  ///< #M by 3, across the edge opposite to corner i, or no_index
  std::vector<Index> objects;                    ///< #M
  std::vector<SheetClearance> clearance;         ///< #M, see below
  double gap = 0;                                ///< least distance that sheets keep, those of attached objects aside

  double front(Index v) const { return z[v] + thickness[v]; }
  double back(Index v) const { return z[v] - thickness[v]; }
};

/// The sheets with the triangles that they were solved with.
///
/// Over a triangle, the front and the back may be moved by their clearance and still keep the gap from the sheet next
/// to them: half of what lies between the two beyond that; infinity where there is none. Fronts of attached objects
/// keep their order.
/// @param objects per lifted triangle
SheetMesh make_sheet_mesh(const InflatedSheets& sheets, const std::vector<Index>& objects);

/// Doubles the region: front and back share the boundary vertices. One surface per object, in the figure's order; an
/// object may have several components. Fronts come first; vertices in the order of the triangles.
std::vector<Shell> object_surfaces(const LabelledFigure& figure, const SheetMesh& sheets);

/// Flips edges and collapses short ones where triangles of the front or the back are slender in space.
///
/// Triangles that are even in the plane aren't so where a surface is steep, and each sheet carries the points of all
/// others. The rim stays as it is, no edge joins two of its vertices, every triangle keeps its sense in the plane, and
/// no sheet moves by more than its clearance, so that those that were apart stay apart. O(M) in practice.
/// @throws Cancelled
void improve_triangles(SheetMesh& mesh, Progress& progress);

}  // namespace croquis::silhouette
