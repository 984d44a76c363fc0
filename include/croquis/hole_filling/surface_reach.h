// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// A vertex of the surface around a hole.
struct ReachedVertex {
  Index vertex = 0;            ///< of the view
  double distance = 0;         ///< along edges to the nearest rim vertex of the site
  Vec3 normal = Vec3::Zero();  ///< unit, weighted by the angles of its sound triangles; 0 where they give none
  Index corner = 0;            ///< of the view, one there
  bool on_crease = false;      ///< a crease (see crease_cosine) starts, ends or passes there
};

/// The vertices that edges join to the site's rims within `reach` (model units): other sheets that merely pass nearby
/// aren't among them. Ordered by distance, then by number. n log n in what is reached.
std::vector<ReachedVertex> reach_from_rims(const HoleSite& site, double reach);

}  // namespace croquis::hole_filling
