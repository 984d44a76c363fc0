// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

/// From a labelled figure to closed solids that keep the drawn order and never touch.
/// Cordier, Seo, Cho 2006, sections 4 and 5.
namespace croquis::silhouette {

/// One solid and what is known about it.
struct SolidObject {
  std::string name;
  std::vector<Index> strokes;  ///< indices into Drawing::strokes
  int euler_region = 0;        ///< of the immersed region
  int euler_mesh = 0;          ///< of its mesh, counted; twice euler_region
};

struct SolidDiagnostics {
  std::size_t skeleton_vertices = 0;
  std::size_t collision_constraints = 0;
  double scale = 0;  ///< L: median skeleton radius, sketch units (largest part's)
  double minimum_gap =
      0;  ///< least distance along z between successive sheets, measured on the mesh; infinity if none overlap
  double silhouette_iou = 0;  ///< of the mesh's projection and the drawn region
  int solver_iterations = 0;  ///< of the depth solves, the largest
  double solver_residual = 0;
};

/// The solids of a drawing.
struct Solid {
  PolyMesh mesh;      ///< triangles of all objects; face channel "object" names them
  PolyMesh skeleton;  ///< polylines; vertex channel "radius"
  std::vector<SolidObject> objects;
  SolidDiagnostics diagnostics;
  Findings findings;  ///< warnings, and the errors of parts that could not become solid
};

/// Sections 8 to 13 for every part of a labelled drawing.
/// @throws Error when no part becomes a solid; Cancelled
Solid inflate(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options, Progress& progress);

}  // namespace croquis::silhouette
