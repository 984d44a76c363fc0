// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The quad cage of a figure, all of its objects.
struct FigureCage {
  PolyMesh mesh;               ///< no channels
  std::vector<Index> objects;  ///< per face, of the figure
  std::size_t caps = 0;
  Overlap overlap;  ///< of the Catmull-Clark surface with the drawing
};

/// Quads along the chordal axis, moved until the mean of the Catmull-Clark and Doo-Sabin surfaces goes through the
/// sheets' front and back, and through the contours.
/// @param spacing of rings, local radii
/// @throws Error (E_INTERNAL) when the figure contradicts itself, Cancelled
FigureCage figure_cage(const LabelledFigure& figure, const InflatedSheets& sheets, double spacing, Progress& progress);

/// One Catmull-Clark refinement of a closed mesh of quads. Subdivision proper knows tags, too, and lies elsewhere.
PolyMesh refined_quads(const PolyMesh& cage);

}  // namespace croquis::silhouette
