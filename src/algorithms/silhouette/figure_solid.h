// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/silhouette/joining/far_copies.h"
#include "algorithms/silhouette/joining/joining.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/shell.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// How one figure is made solid.
struct FigureSettings {
  DepthSettings depth;
  Quality quality = Quality::Final;
  StageCache* cache = nullptr;
  std::vector<Index> copied = {};  ///< ascending, objects that have a copy on the far side
};

/// The settings of every figure, before any work: what is mistyped is reported at once.
///
/// Attached are the pairs of objects that the options name, and, where asked for, those that look attached and aren't
/// named. A pair that doesn't overlap, or whose object couldn't be labelled, is left out with a warning
/// (W_ATTACH_APART).
///
/// An object's weights are the options', unless its group sets others by "weight-curvature", "weight-orientation" or
/// "weight-distance". How deep it is against its width is 1, or a little less where it rests wholly before another one,
/// unless "thickness" says otherwise, of a named object's group or of the first of its strokes that says something.
/// @param warnings is given W_ATTACH_APART
/// @throws Error with one E_ATTACH for every pair that names something unknown, or one object twice, or has a kappa or
///         blend outside 0..1; with one E_PARAMETER for every value that isn't a number in 1e-3..1 or, of a thickness,
///         in 0.05..4, naming the object
std::vector<FigureSettings> figure_settings(const LabelledDrawing& labelled, const Drawing& drawing,
                                            const Options& options, Findings& warnings);

struct FigureShells {
  std::vector<Shell> shells;                           ///< the sound ones, by their first objects
  std::vector<std::pair<Index, std::string>> refused;  ///< objects, and what is wrong with their surfaces
  std::vector<FailedJoin> failed;  ///< pairs to be kept apart; where there are any, the rest doesn't count
  std::vector<Index> lost;         ///< objects whose copies on the far side would have met others, and were left out
};

/// Joins the surfaces of attached objects and checks what comes of them: closed, manifold, showing what was drawn,
/// apart from all others on the numbers as they are and as files may round them. Without attachments nothing is checked
/// here.
/// Seams are rounded where that leaves everything sound, else those at fault with half the radius and so on, else not
/// at all. Copies on the far side belong to the objects that were drawn in what is returned.
/// @param held surfaces in the figure's order, then copies; seams of other pairs stay sharp
/// @throws Cancelled
FigureShells make_shells(const LabelledFigure& figure, HeldSurfaces held, Progress& progress);

/// What one figure of a drawing becomes.
struct FigureSolid {
  std::vector<Shell> shells;  ///< the sound ones, by their first objects
  Attachments held;           ///< joined ones only where they could be, their seams as far as they were rounded
  Skeleton skeleton;
  SolidDiagnostics diagnostics;                  ///< without silhouette_iou
  Overlap overlap;                               ///< of the shells with the drawing
  std::shared_ptr<const InflatedSheets> sheets;  ///< before anything was joined
  std::map<Index, double> mirrored;  ///< objects with a copy on the far side: the depth that it is mirrored at
  Findings findings;
};

/// Skeleton, depths, sheets, surfaces, checks; attached objects joined. Pairs that can't be joined are reported, and
/// the figure is made again with these apart. A draft isn't checked, measured against the drawing, or joined.
/// @throws Error when the figure becomes no solid at all; Cancelled
std::shared_ptr<const FigureSolid> make_figure_solid(const LabelledFigure& figure, const Drawing& drawing,
                                                     const FigureSettings& settings, Progress& progress);

/// The strokes of an object as subjects of a finding.
std::vector<Subject> object_subjects(const FigureObject& object, const Drawing& drawing);

}  // namespace croquis::silhouette
