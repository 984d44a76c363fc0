// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// What every part of a drawing is searched in.
struct FigureContext {
  const Drawing& drawing;
  const Options& options;
  const DrawingScale& scale;
  const std::vector<CleanLine>& lines;  ///< carried on behind their bars
  const Junctions& junctions;
  const VisibleCrossings& order;
  double completion_reference = 1;  ///< length that completions are measured by
};

/// One of the two is empty, unless some of the lines were left out.
struct FigureSearch {
  std::optional<LabelledFigure> figure;
  Findings findings;  ///< E_NO_LABELLING, E_TOUCH
};

/// Completes and labels the contours of some lines together: tries the perfect matchings of their hidden ends from the
/// cheapest on, until one can be labelled (Cordier, Seo, Cho 2006, section 3; Williams 1994).
/// @param lines ascending
FigureSearch search_figure(const FigureContext& context, const std::vector<Index>& lines, const Progress& progress);

}  // namespace croquis::silhouette
