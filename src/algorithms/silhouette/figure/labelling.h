// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/solver/integer_program.h"

namespace croquis::silhouette {

/// Reads what the drawing leaves open: whether a closed outline within another, whose side no junction gives, bounds a
/// hole or a part in front. Sets the sides of the arrangement's contours.
///
/// A stroke's own "kind" decides, then its object: outlines of different named objects are no holes of each other. Else
/// it is judged by its shape. Holes are what rings of even width go round, along most of the outline; the thicker the
/// ring for its hole, the more does whatever lies over it, or beside the hole in the same outline, speak for a part: a
/// belly or an eye on a body rather than a ring.
/// O(#nested * samples of the two contours).
std::vector<NestedOutline> read_nesting(const Drawing& drawing, Arrangement& arrangement);

/// The labelled figure's numbers; none where no labelling was found.
struct Labelling {
  std::vector<int> depth;                ///< per arc: n, surfaces in front of it
  std::vector<int> side;                 ///< per contour: surface on its left (+1) or right (-1)
  std::vector<std::uint8_t> is_swapped;  ///< per crossing: the second strand is in front
  // With slack and blame:
  std::vector<Index> wrong_arcs;       ///< would have to be hidden in the open, or visible though covered
  std::vector<Index> wrong_crossings;  ///< depths don't change as they must
  std::vector<Index> wrong_faces;      ///< have less than no surface
};

/// How strictly to label.
enum class LabellingRules {
  Full,   ///< all rules
  Slack,  ///< arcs may break the rule of what is seen, at a price
  Blame   ///< as above, and every other rule may be broken at a higher price: there is always a solution
};

/// Labels by integer programming (Williams 1994; Cordier, Seo, Cho 2006, section 3). For arcs e, contours c, crossings
/// k of A and B with sign s, and sigma = 2 o - 1:
///   (a) w = Σ sigma_c winding_c >= 0 in every face
///   (b) n_e <= (w_left + w_right - 1) / 2
///   (c) A over B: n(B+) - n(B-) = s sigma_A, n(A+) = n(A-), and A's depths are at most B's
///   (d) B over A: n(A+) - n(A-) = -s sigma_B, and so on
///   (f) visible arcs n = 0, hidden arcs n >= 1, unless what is drawn may be covered; sigma and the upper contour where
///   T-junctions give them
/// minimising Σ n plus a little of the covered area, so that of two readings the one with a hole wins.
/// @param arrangement its contours' sides are kept where they are known; where there are no faces, their rules are left
/// out
Labelling label_arrangement(const Arrangement& arrangement, LabellingRules rules);

/// Puts the labelled figure together: contours, arcs and crossings as labelled, and the objects that its panels are
/// glued to (Williams 1994): across an arc of depth n, from the side with more layers, panel i goes on as i for i < n
/// and as i - 1 for i > n; panel n ends there. None when a contour would bound two components.
std::optional<LabelledFigure> build_figure(const FigureContext& context, Arrangement arrangement,
                                           const Labelling& labelling);

/// Name of the object that the strokes of one outline are forced into, empty for none.
std::string object_of_strokes(const Drawing& drawing, const std::vector<Index>& strokes);

/// One note (W_NESTED) for every outline that was read by its shape.
Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure);

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
