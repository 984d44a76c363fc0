// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The closed surface of one object of a figure.
struct ObjectSurface {
  PolyMesh mesh;         ///< triangles, outward; front of every sheet first, then the backs
  Index object = 0;      ///< in the figure
  int euler_region = 0;  ///< of the part of the region that it doubles, counted
};

/// Doubles the region: front and back share the boundary vertices. One surface per object, in the figure's order; an
/// object may have several components. Vertices in the order of the triangles, fronts first.
std::vector<ObjectSurface> object_surfaces(const LabelledFigure& figure, const SheetMesh& sheets);

/// The object that each lifted triangle belongs to.
/// @throws Error (E_INTERNAL) when a component of the region is bounded by contours of two objects
std::vector<Index> objects_of_triangles(const LabelledFigure& figure, const SheetSampling& sheets);

}  // namespace croquis::silhouette
