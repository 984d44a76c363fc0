// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {

/// A stroke sampled evenly.
struct SampledStroke {
  Points points;
  Index stroke = 0;    ///< index into Drawing::strokes
  std::string object;  ///< strokes of two named objects are never joined
  StrokeKind told = StrokeKind::Visible;
  bool closed = false;
  double length = 0;
  double size = 0;  ///< see `size_of`
};

/// One stroke in a chain of joined strokes.
struct ChainLink {
  Index index = 0;  ///< into the sampled strokes
  bool reversed = false;
};

/// Strokes that together are one line.
struct StrokeChain {
  std::vector<ChainLink> links;  ///< in order along the line; the stroke drawn first keeps its direction
  bool closed = false;
};

/// The line that a chain of strokes makes, not smoothed yet. What runs on beyond the place where the next stroke (or
/// the first one again) goes on is cut off; ends that lie aside of one another are bent to meet when the drawing's
/// scale has an aside_share.
CleanLine join_chain(const StrokeChain& chain, const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
