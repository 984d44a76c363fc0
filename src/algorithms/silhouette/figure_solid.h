// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// A closed surface: of one object, or of several joined.
struct FigureShell {
  PolyMesh mesh;
  std::vector<Index> objects;       ///< of the figure, ascending
  std::vector<Index> face_objects;  ///< per face; empty: all are the only object's
  int euler = 0;                    ///< counted
  std::size_t pieces = 1;           ///< that share no vertex
};

/// What one figure of a drawing becomes.
struct FigureSolid {
  std::vector<FigureShell> shells;  ///< the sound ones, by their first objects
  Attachments attachments;          ///< those that could be made
  PolyMesh skeleton;
  SolidDiagnostics diagnostics;  ///< without silhouette_iou
  Overlap overlap;               ///< of the shells with the drawing
  Findings findings;
};

struct FigureSettings {
  DepthSettings depth;
  Quality quality = Quality::Final;
  StageCache* cache = nullptr;
};

/// Skeleton, depths, sheets, surfaces, checks; attached objects joined. A group of attached objects that can't be
/// joined to a sound surface is made again with gaps. A draft isn't checked, measured against the drawing, or joined.
/// @throws Error when the figure becomes no solid at all; Cancelled
std::shared_ptr<const FigureSolid> make_figure_solid(const LabelledFigure& figure, const Drawing& drawing,
                                                     const FigureSettings& settings, Progress& progress);

/// The strokes of an object as subjects of a finding.
std::vector<Subject> object_subjects(const FigureObject& object, const Drawing& drawing);

}  // namespace croquis::silhouette
