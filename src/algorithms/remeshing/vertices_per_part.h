// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace croquis::remeshing {

/// Vertices (or triangles) that one thread takes at a time: enough that dividing the work costs little.
inline constexpr std::size_t vertices_per_part = 4096;

}  // namespace croquis::remeshing
