// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/operators/attach_text.h"
#include "croquis/operators/inflate_result.h"

/// How pairs of parts are held: what a solid suggests, and what its parameter "attach" says.
namespace croquis::app {

/// Two parts that overlap as limb and body do.
struct Joint {
  std::string a;  ///< names of objects
  std::string b;
  Vec2 at = Vec2::Zero();                                ///< sketch units
  silhouette::Hold hold = silhouette::Hold::Apart;       ///< as it is wanted
  silhouette::Hold by_itself = silhouette::Hold::Apart;  ///< without an entry of its own
  double blend = 0;                                      ///< of joined ones: radius of the seam, 0 to 1
  bool held = true;                                      ///< false: the newest solid couldn't be made so
};

/// With the names of objects for those strokes by which entries may name them.
AttachText with_object_names(AttachText attach, const InflateResult& inflated);

/// Of a solid's newest result. @param attach with names of objects; @param is_final it is no draft: then what isn't
/// held is known
std::vector<Joint> joints_of(const InflateResult& inflated, const AttachText& attach, bool is_final);

/// Apart, resting, joined, and apart again.
silhouette::Hold next_hold(silhouette::Hold hold);

/// With the pair held so; without an entry where it is by itself.
AttachText with_hold(AttachText attach, const Joint& joint, silhouette::Hold hold);

/// With the pair joined with a seam of this radius, limited to 0 to 1.
AttachText with_blend(AttachText attach, const Joint& joint, double blend);

}  // namespace croquis::app
