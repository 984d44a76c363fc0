// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "algorithms/silhouette/figure/arrangement_faces.h"
#include "algorithms/silhouette/figure/labelling.h"

namespace croquis::silhouette {

/// A place where one sheet passes over another: a connected region of pairs of panels.
struct PanelOverlap {
  Vec2 at = Vec2::Zero();  ///< inside it
  Index upper_component = 0;
  Index lower_component = 0;
  std::vector<Index> crossings;  ///< of the arrangement, at the corners of the region; ascending
};

/// The stacks of panels and how they are connected.
struct Paneling {
  std::vector<Index> first_panel;  ///< per face, one more at the end; panel (f, i) is first_panel[f] + i
  std::vector<Index> component;    ///< per panel
  std::vector<Index> component_of_contour;
  Index component_count = 0;           ///< numbered by the first contour that bounds them
  bool sound = true;                   ///< every contour bounds one component only
  std::vector<PanelOverlap> overlaps;  ///< by upper, lower component
};

/// Glues the panels (Williams 1994): across an arc of depth n, from the side with more layers, panel i goes on as i for
/// i < n and as i - 1 for i > n; panel n ends there.
Paneling glue_panels(const Arrangement& arrangement, const Faces& faces, const std::vector<int>& layers,
                     const std::vector<int>& depth);

/// Times that a closed polyline turns round, counter-clockwise positive; a region's Euler number is the sum of
/// side * turns over its contours.
int turning_number(const Points& points);

}  // namespace croquis::silhouette
