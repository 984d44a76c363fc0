// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"

namespace croquis::silhouette {

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
/// @param arrangement its contours' sides are kept where they are known
/// @param faces       where there are none, the rules of faces are left out
Labelling label_arrangement(const Arrangement& arrangement, const Faces& faces, LabellingRules rules);

}  // namespace croquis::silhouette
