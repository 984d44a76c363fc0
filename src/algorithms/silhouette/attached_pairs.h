// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "algorithms/silhouette/skeleton/attachments.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// How the objects of one figure are held.
struct HeldObjects {
  Attachments attachments;
  std::map<Attachments::Pair, double> blends;  ///< of joined pairs, see AttachedPair; none: a sharp seam
};

struct AttachedFigures {
  std::vector<HeldObjects> figures;  ///< per figure
  Findings warnings;                 ///< W_ATTACH_APART
};

/// Finds the objects that the options attach: the pairs that they name, and, where asked for, those that look attached
/// and aren't named. A pair that doesn't overlap, or whose object couldn't be labelled, is left out with a warning.
/// @throws Error with one E_ATTACH for every pair that names something unknown, or one object twice, or has a kappa or
///         blend outside 0..1
AttachedFigures attached_figures(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options);

}  // namespace croquis::silhouette
