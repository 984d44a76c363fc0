// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/figure/figure_search.h"

namespace croquis::silhouette {

/// The lines, ends and candidates of one part of a drawing.
struct PartLines {
  std::vector<Index> lines;                     ///< ascending
  std::vector<Index> ends;                      ///< indices into Junctions::ends, ascending
  std::vector<CompletionCandidate> candidates;  ///< between positions in `ends`
};

/// A completion that is taken.
struct ChosenCompletion {
  Index candidate = 0;
  Index shape = 0;  ///< position in the candidate's shapes
};

/// Closed contours that a choice of completions makes of the lines.
struct ClosedContours {
  std::vector<ContourPath> paths;             ///< by the lowest line in them
  std::vector<FigureCompletion> completions;  ///< one per candidate chosen
};

/// Joins lines and completions. None when they would put the surface on both sides of a contour.
/// @param chosen  every end in exactly one
std::optional<ClosedContours> close_contours(const FigureContext& context, const PartLines& part,
                                             const std::vector<ChosenCompletion>& chosen);

}  // namespace croquis::silhouette
