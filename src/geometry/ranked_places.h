// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"
#include "geometry/packed_box.h"

namespace croquis {

/// Points as whole numbers: along each axis the rank of a coordinate among the different ones, stretched to the whole
/// range. Whether boxes overlap depends on the order of coordinates alone, so that boxes of ranks overlap wherever
/// those of points do: nothing is rounded, at any scale, however far an outlier lies. And nowhere else, up to 2^20
/// different coordinates; beyond, neighbours share a rank.
/// @param positions finite
std::vector<PackedPlace> ranked_places(std::span<const Vec3> positions);

}  // namespace croquis
