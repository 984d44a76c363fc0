// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "croquis/base/progress.h"
#include "croquis/solver/integer_program.h"

namespace croquis::silhouette {

/// A pair that may be matched, at a price; a node with itself: it may be left out.
struct MatchingEdge {
  Index a = 0;
  Index b = 0;
  double cost = 0;
};

/// Enumerates perfect matchings of a graph from the cheapest on: one integer program with a 0-1 variable for each edge
/// and a row for each node, from which what was found is excluded.
class MatchingSearch {
 public:
  /// @param maximum_branches bound of all searches together
  MatchingSearch(Index nodes, const std::vector<MatchingEdge>& edges, int maximum_branches);

  /// The next matching as edge indices, ascending; none when there are no more or the bound was reached.
  std::optional<std::vector<Index>> next();

  bool limit_reached() const { return branches_left_ <= 0; }

 private:
  IntegerProgram program_;
  int branches_left_;
  bool done_ = false;
};

/// Completes and labels the contours of a drawing: tries the perfect matchings of hidden ends from the cheapest on,
/// until one can be labelled (Cordier, Seo, Cho 2006, section 3; Williams 1994).
///
/// Lines that stop at one another, or are forced into one object, are connected. Those whose bounding boxes overlap are
/// solved together; when that fails, as many of them as go together, so that one bad object doesn't exclude the others.
/// Lines of which the junctions have findings are left out.
/// @return figures, and findings (E_NO_LABELLING, E_TOUCH) of what couldn't be labelled
LabelledDrawing label_parts(const FigureContext& context, const Progress& progress);

}  // namespace croquis::silhouette
