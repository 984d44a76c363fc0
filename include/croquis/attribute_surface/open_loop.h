// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/attribute_surface/loop_search.h"

namespace croquis {

/// The loop that lacks its face, so that hosts can offer it by itself: of the curves along fewer than two faces the one
/// drawn last that fewest other curves lead back from, as long as that loop is no face yet. Curves inside faces are no
/// borders. Breadth first, O(#curves²) at worst.
/// @return closed, or empty where there is none
SortedLoop open_loop(const AttributeNetwork& network, const LoopSearchOptions& options = {});

}  // namespace croquis
