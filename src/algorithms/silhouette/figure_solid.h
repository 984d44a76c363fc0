// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "algorithms/silhouette/attached_pairs.h"
#include "algorithms/silhouette/figure_shells.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// What one figure of a drawing becomes.
struct FigureSolid {
  std::vector<Shell> shells;  ///< the sound ones, by their first objects
  HeldObjects held;           ///< joined ones only where they could be
  Skeleton skeleton;
  SolidDiagnostics diagnostics;  ///< without silhouette_iou
  Overlap overlap;               ///< of the shells with the drawing
  Findings findings;
};

struct FigureSettings {
  DepthSettings depth;
  std::map<Attachments::Pair, double> blends;  ///< see HeldObjects
  Quality quality = Quality::Final;
  StageCache* cache = nullptr;
};

/// Skeleton, depths, sheets, surfaces, checks; attached objects joined. Pairs that can't be joined are reported, and
/// the figure is made again with these apart. A draft isn't checked, measured against the drawing, or joined.
/// @throws Error when the figure becomes no solid at all; Cancelled
std::shared_ptr<const FigureSolid> make_figure_solid(const LabelledFigure& figure, const Drawing& drawing,
                                                     const FigureSettings& settings, Progress& progress);

/// The strokes of an object as subjects of a finding.
std::vector<Subject> object_subjects(const FigureObject& object, const Drawing& drawing);

}  // namespace croquis::silhouette
