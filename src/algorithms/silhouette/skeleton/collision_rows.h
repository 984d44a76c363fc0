// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// z[upper] - z[lower] >= bound keeps the circles of two chords apart.
struct CollisionRow {
  Index upper = 0;
  Index lower = 0;
  double bound = 0;
  double reach = 0;  ///< of joined objects: so far apart along z the two still sink into one another
};

/// For panels directly above one another, every node whose chord passes through the upper one against every node of the
/// lower one: with R = r_a + r_b + gap and plane distance l < R, z_a - z_b >= sqrt(R^2 - l^2).
/// Cordier, Seo, Cho 2006, section 4.4.1. Ordered by upper, then lower node, each pair once.
///
/// For attached objects R = kappa (r_a + r_b), and the upper one's rim, which is about as high as its axis, lies no
/// deeper than the lower one's front: there it is seen. Sinking into one another isn't transitive: in a figure with
/// attachments all panels of a stack get rows against one another, not only neighbours.
/// Where objects aren't as deep as they are wide, the two circles are ellipses.
std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure,
                                         const DepthSettings& settings = {});

}  // namespace croquis::silhouette
