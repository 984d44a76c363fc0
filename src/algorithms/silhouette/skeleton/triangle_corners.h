// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Corners 0, 1, 2 of a triangle, counter-clockwise and clockwise.
constexpr Index next(Index corner) { return corner == 2 ? 0 : corner + 1; }
constexpr Index previous(Index corner) { return corner == 0 ? 2 : corner - 1; }

}  // namespace croquis::silhouette
