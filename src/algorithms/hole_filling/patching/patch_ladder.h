// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "algorithms/hole_filling/patching/patcher.h"
#include "croquis/hole_filling/hole_request.h"

namespace croquis::hole_filling {

/// The methods for a hole in the order in which they are tried; see "Methods" in docs/algorithms/hole_filling.md.
/// @param is_cap closes an open section, whatever the wish: flat
/// @param most_triangles a patch that would need more is made of larger triangles
/// What the site itself needs comes first: a band where two rims are to be bridged or are a tunnel's, a zip for a
/// slit, the implicit continuation where the patch is to go through places.
Ladder ladder_for(const HoleSite& site, Preset preset, bool is_cap, std::size_t most_triangles);

/// The same by a wish alone.
Ladder ladder_for(const PatchWish& wish, Preset preset, bool is_cap, std::size_t most_triangles);

}  // namespace croquis::hole_filling
