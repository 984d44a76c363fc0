// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// A control mesh of few quads whose subdivision surfaces, Catmull-Clark's and Doo-Sabin's, are close to the solids of
/// a drawing: each object is a closed surface of its own.
///
/// Rings of eight vertices run round every limb, and the outline is a loop of edges. Front and back are images of each
/// other over the middle of the depth.
struct QuadCage {
  PolyMesh mesh;           ///< face channel "object", as Solid::mesh has it
  std::size_t caps = 0;    ///< tips of limbs, each of four quads
  std::size_t shells = 0;  ///< closed surfaces
  bool mirror = false;     ///< it is its own image, left to right; what nearly is becomes so
  /// Of the drawing and the Catmull-Clark surface's projection.
  double silhouette_iou = std::numeric_limits<double>::quiet_NaN();
};

struct CagedSolid {
  Solid solid;
  QuadCage cage;
};

/// The solids of a drawing, see `inflate`, with a cage.
/// @param rings distance of the rings around limbs, local radii, 0.3..3
/// @throws as `inflate` does
CagedSolid inflate_with_cage(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options,
                             double rings, Progress& progress);

}  // namespace croquis::silhouette
