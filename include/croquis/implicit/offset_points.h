// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/implicit/local_fit.h"

namespace croquis::implicit {

struct OffsetOptions {
  double distance = 0;     ///< first distance d of an offset point, model units, > 0; usual: half the mean edge
  int halvings = 6;        ///< d is halved so often at most, then the point is left out
  bool both_sides = true;  ///< false: outside only, as in Yoo 2005
};

struct OffsetPoints {
  Constraints constraints;     ///< the points on the surface first (value 0), then those off it; no gradients
  std::vector<Index> origins;  ///< of every point off the surface, the surface point it belongs to
  std::size_t shortened = 0;   ///< offset points that came nearer than asked for
  std::size_t dropped = 0;     ///< offset points left out
};

/// Points on the surface and, along their normals, points of signed distance +d outside and -d inside, for kernels that
/// take values alone.
///
/// An offset point stays only where its nearest surface point is the one it comes from (no other nearer than 0.98 d):
/// else d is halved. So none ever crosses the middle of a thin wall or gap.
/// @param positions #N; @param normals #N, unit length; 0 where unknown: no offset points there
/// Time N log N for points of a surface.
/// @throws Error (E_COUNT, E_PARAMETER, E_NOT_FINITE)
OffsetPoints with_offset_points(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                const OffsetOptions& options);

}  // namespace croquis::implicit
