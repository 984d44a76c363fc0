// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"
#include "geometry/packed_box.h"
#include "geometry/triangle_meeting.h"

namespace croquis {

/// Points as whole numbers: along each axis the rank of a coordinate among the different ones, stretched to the whole
/// range. Whether boxes overlap depends on the order of coordinates alone, so that boxes of ranks overlap wherever
/// those of points do: nothing is rounded, at any scale, however far an outlier lies. And nowhere else, up to 2^20
/// different coordinates; beyond, neighbours share a rank.
/// @param positions finite
std::vector<PackedPlace> ranked_places(std::span<const Vec3> positions);

/// Points as whole numbers for the boxes of triangles: even steps from the least coordinate to the greatest one along
/// each axis, which are counted faster than ranks. By ranks where such steps aren't much smaller than usual triangles,
/// as with a vertex far out. Boxes overlap wherever those of points do, and hardly anywhere else.
/// @param positions finite
/// @return per position; anything where no triangle uses it
std::vector<PackedPlace> places_for_boxes(const std::vector<Vec3>& positions,
                                          std::span<const MeetingTriangle> triangles);

}  // namespace croquis
