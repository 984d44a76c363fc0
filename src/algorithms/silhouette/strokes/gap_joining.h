// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/stroke_reading.h"

namespace croquis::silhouette {

/// A stroke sampled evenly enough that its length can be counted in samples.
struct SampledStroke {
  Points points;
  Points raw;          ///< as drawn
  Index stroke = 0;    ///< index into Drawing::strokes
  std::string object;  ///< strokes of two named objects are never joined
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

struct GapJoin {
  Index first = 0;  ///< indices into the sampled strokes
  Index second = 0;
  double distance = 0;
  Vec2 at = Vec2::Zero();
};

struct GapJoining {
  std::vector<StrokeChain> chains;  ///< by the lowest stroke in them
  std::vector<EndPair> joined;      ///< all joined ends
  std::vector<EndPair> possible;    ///< other pairs of ends that are near enough, only with tolerances by size
  std::vector<GapJoin> joins;       ///< strokes whose own ends met within DrawingScale::close are not listed
};

/// Finds the ends that were meant to meet, nearest pair first.
///
/// Two ends belong together when they are near, run in the same direction, and nothing lies between them: a line across
/// the bridge means that the strokes pass behind it. The two ends of one stroke that are very near close it, and those
/// that miss each other by no more than a hand does (DrawingScale::close_share, aside_share).
/// @param spacing distance of the samples. O(n log n).
GapJoining join_gaps(const std::vector<SampledStroke>& strokes, const StrokeReading& reading, const DrawingScale& scale,
                     double spacing);

}  // namespace croquis::silhouette
