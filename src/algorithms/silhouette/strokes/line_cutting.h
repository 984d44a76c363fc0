// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/covered_runs.h"

namespace croquis::silhouette {

/// A covered stretch of a line, and on which side of the lines that cover it at both ends their surfaces lie.
struct CutRun {
  LineRun run;
  int begin_side = 0;
  int end_side = 0;
};

/// Appends what is left of a line when stretches are cut out of it, and the stretches as hidden pieces between the ends
/// they leave. A stretch at an end of an open line is dropped. A line of which nothing is left stays whole.
/// @param cuts of a closed line in order round it, starting anywhere; of an open one ascending; they don't overlap
/// @param spacing no sample lies nearer to a new end than this
void append_cut(const CleanLine& line, const std::vector<CutRun>& cuts, double spacing, std::vector<CleanLine>& lines,
                std::vector<HiddenPiece>& pieces);

}  // namespace croquis::silhouette
