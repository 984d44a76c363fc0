// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/subdivision/levels/weight_rows.h"
#include "algorithms/subdivision/refinement/face_mask.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// How the points of a level follow from those of the level before, where plain faces don't decide it.
struct PointRules {
  std::vector<Index> gap_faces;        ///< old faces of which not all corners have a point of their own, ascending
  std::vector<Index> adjusted_corner;  ///< old corners whose points differ from the plain rule, ascending
  std::vector<double> plain_share;     ///< for each of these how much of the plain point stays …
  WeightRows adjusted;                 ///< … and what comes to it
  WeightRows listed;                   ///< the points behind those of corners, in order
};

/// Rules beside and on tagged edges: presets differ here alone.
PointRules make_point_rules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask);

}  // namespace croquis::subdivision
