// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_meeting.h"

namespace croquis {

/// Vertices whose triangles certainly meet each other in common vertices and edges alone, by one test of each vertex
/// instead of one of each pair.
///
/// A star is spread when its triangles close around the vertex in one ring and there is a direction from which all of
/// them are seen from the same side, once around: seen so they tile the neighbourhood of the vertex, each in its own
/// sector, and neighbours have nothing but their edge in the border of both sectors. Most vertices of a surface are
/// like that; those on borders aren't reported.
/// @param triangles any, with an area
/// @return per vertex, not 0 where its star is clearly spread
std::vector<char> spread_stars(const std::vector<Vec3>& positions, std::span<const MeetingTriangle> triangles);

}  // namespace croquis
