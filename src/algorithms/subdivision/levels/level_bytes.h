// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "algorithms/subdivision/refinement/refine.h"

namespace croquis::subdivision {

/// Memory held by their arrays.
std::size_t bytes_of(const Level& level);
std::size_t bytes_of(const Refinement& refinement);

}  // namespace croquis::subdivision
