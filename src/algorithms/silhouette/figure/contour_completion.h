// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/silhouette/figure/completion_shapes.h"
#include "algorithms/silhouette/figure/drawn_cover.h"
#include "algorithms/silhouette/strokes/cubic_join.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// A hidden piece of contour that might join two ends.
struct CompletionCandidate {
  Index a = 0;  ///< indices of ends, a < b
  Index b = 0;
  /// From a to b, leaving both along their tangents.
  std::array<Vec2, 4> bezier{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  double plain_cost = 0;    ///< of its curve, dimensionless
  double strip_factor = 1;  ///< see hidden_strips.h
  double cost = 0;          ///< what it costs after all; until it is judged no more than that
  /// Indices into completion_shapes, or kept_behind_shape; once judged those that keep the piece covered by what is
  /// drawn come first.
  std::vector<std::uint8_t> shapes{0, 1, 2, 3, 4, 5, 6, 7};
  bool one_bar = false;    ///< both ends pass behind the same side of the same line
  bool judged = false;     ///< by what covers it
  Index given = no_index;  ///< index into Junctions::given: then that piece counts instead of the curve
};

/// length / reference + weight * distance * integral of curvature², both free of scale: a half circle costs the same
/// bending at any size (Williams 1994 uses the two terms with dimensions, which favours long straight joins).
/// Bending away from the surface counts more: the hidden end of a limb is a cap, seldom the crotch between two limbs.
/// @param side where the surface lies along the curve: left (+1), right (-1), not known (0)
double completion_cost(const std::array<Vec2, 4>& curve, int side, double reference_length,
                       const CompletionOptions& options);

/// The length that completions are measured by: the median over the hidden ends that have to be joined of the distance
/// to the nearest other. O(n²) for n ends.
double completion_reference(const std::vector<CleanLine>& lines, const Junctions& junctions);

/// All pairs of the given ends that may be joined: the surface lies on the same side of both lines as far as that is
/// known, neither is forced into another object, and the cost stays below the maximum. Ends that a known piece joins
/// have that one candidate. Caps of limbs (hidden_caps.h) and pieces that carry a strip straight on behind something
/// (hidden_strips.h) cost less.
/// @param ends subset of junctions.ends, as indices; candidates hold positions in this list
/// O(n²) for n ends.
std::vector<CompletionCandidate> completion_candidates(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                                       const std::vector<Index>& ends, double reference_length,
                                                       const CompletionOptions& options);

/// Judges candidates by what is drawn in front of them. That takes longer than to find them, so that only those are
/// judged that may be chosen.
class CompletionJudge {
 public:
  /// @param lines carried on behind their bars; must outlive this
  CompletionJudge(const std::vector<CleanLine>& lines, const Junctions& junctions) : cover_(lines, junctions) {}

  /// Brings the shapes that keep a candidate covered to the front, and makes it dearer when there is none.
  /// @returns whether it costs more than before; a candidate that was judged stays as it is
  bool judge(CompletionCandidate& candidate) const;

 private:
  DrawnCover cover_;
};

/// The few cheapest candidates of every end, ascending; dearer ones aren't worth judging.
/// @param ends how many there are
std::vector<Index> likely_candidates(std::size_t ends, const std::vector<CompletionCandidate>& candidates);

/// Side of the surface when a line is walked outward through one of its ends: +1 left, -1 right, 0 unknown.
inline int outward_side(const Junctions& junctions, const HiddenEnd& end) {
  return end.at_start ? -junctions.sides[end.line] : junctions.sides[end.line];
}

}  // namespace croquis::silhouette
