// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <Eigen/Geometry>

#include "croquis/base/limits.h"
#include "croquis/geometry/drawing.h"
#include "io/svg/svg_outline.h"

namespace croquis {

struct FlatteningLimits {
  Eigen::AlignedBox2d bounds;  ///< of the whole drawing
  double tolerance = 0;        ///< greatest distance of samples' chords from the curve
  std::size_t samples_left = most_curve_pieces;
};

/// Whether all its numbers are usable (limits.h).
bool is_usable(const SvgSubpath& subpath);

/// Makes the box hold the subpath, to within a fraction of each curve's own size.
void extend(Eigen::AlignedBox2d& box, const SvgSubpath& subpath);

/// Gives the stroke its samples. A closed one does not repeat its first.
/// @returns false when there would be more samples than are left
bool flatten_into(Stroke& stroke, const SvgSubpath& subpath, FlatteningLimits& limits);

}  // namespace croquis
