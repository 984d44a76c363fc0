// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

/// Limbs that grow out of a body instead of floating before it.
namespace croquis::silhouette {

/// Two objects of a figure that look as if they touch: limb and body, or a part that lies on another.
struct AttachSuggestion {
  Index a = 0;  ///< objects of the figure, a < b
  Index b = 0;
  Vec2 at = Vec2::Zero();  ///< where they overlap, sketch units
  /// Joined for a limb whose outline ends at the other's, Resting for a part wholly before it, and where two closed
  /// outlines cross in full view.
  Hold hold = Hold::Joined;
  bool tube = false;  ///< one is a limb drawn as one line: it is joined unless it is set to stay apart
};

/// The pairs of which one ends within the other's outline: their overlap has two corners, or none where one lies wholly
/// before the other. Where a strand passes right across another, the overlap has four corners: links, knots and weaves
/// get no suggestions, nor do parts with another one between them. Each pair once, in the order of the figure's
/// overlaps. O(#overlaps log #overlaps).
std::vector<AttachSuggestion> attach_suggestions(const LabelledFigure& figure);

}  // namespace croquis::silhouette
