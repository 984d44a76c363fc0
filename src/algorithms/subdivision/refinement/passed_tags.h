// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/subdivision/refinement/edge_matching.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// Passes the tags of a level down: sharpness less one to the children of tagged edges and to the chords that join them
/// at creases; pins and settled corners to the points that stay.
void pass_tags(const Neighbourhood& near, const EdgeMatching& matching, Level& next);

}  // namespace croquis::subdivision
