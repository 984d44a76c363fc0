// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/progress.h"

/// What each end of a stroke may be: a place where the line goes on as another stroke, or one where it passes behind
/// something. Candidates with costs; which of them hold is decided for all together by the reading's program.
namespace croquis::silhouette {

/// Where an open stroke begins or ends. Positions of strokes are those in the list of sampled ones.
struct LineEnd {
  Index stroke = 0;
  bool at_start = false;
  Vec2 place = Vec2::Zero();
  std::array<Vec2, 2> outward{Vec2::Zero(), Vec2::Zero()};  ///< unit, over the last bit and over a longer one
};

/// Two ends that may be one place of one line, or that a hidden piece may join. Ends are positions in
/// Connections::ends.
struct EndJoin {
  Index a = 0;  ///< a < b
  Index b = 0;
  double cost = 0;
  double gap = 0;  ///< in parts of what hands miss by, at most 1; 0 of hidden pieces
};

/// An end that may pass behind a line.
struct EndMeeting {
  Index end = 0;
  Index bar = 0;           ///< stroke
  Vec2 at = Vec2::Zero();  ///< on the bar
  int side = 1;            ///< the bar's surface would lie on the left (+1) or right (-1) of its stroke
  double along = 0;        ///< from the end to the bar; negative where the end lies beyond it
  double cost = 0;
};

struct Connections {
  std::vector<LineEnd> ends;  ///< of open strokes that aren't doubled, in their order: start, end
  std::vector<EndJoin> joins;
  std::vector<EndMeeting> meetings;
  std::vector<EndJoin> hidden;                       ///< pairs that hidden pieces may join
  std::map<std::pair<Index, Index>, int> crossings;  ///< of strokes in full view: how many; (s, s) of s with itself
  std::vector<Index> doubled;                        ///< per stroke, see `doubled_strokes`
};

/// Near O(n) for evenly spread samples. Ends that plainly go on as one another have no other candidates.
Connections find_connections(const std::vector<SampledStroke>& strokes, const DrawingScale& scale,
                             const Progress& progress);

}  // namespace croquis::silhouette
