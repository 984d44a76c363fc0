// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Angles from the rim, seen from the axis, at which rows of points run along every contour, in radians. Thickness
/// grows like a square root at the rim: without close rows the silhouette would be serrated; more of them gain nothing.
inline constexpr double row_angles[] = {0.2617993877991494, 0.6108652381980153, 1.0471975511965976};  // 15, 35, 60 deg

/// Distance of a row from the rim of a round tube of that radius.
double row_depth(double radius, double angle);

/// Per contour and position the radius of the surface there: that of the chords, filled in along the contour where none
/// ends and smoothed. A contour without any chord takes the skeleton's scale.
std::vector<std::vector<double>> rim_radii(const LabelledFigure& figure, const Skeleton& skeleton);

}  // namespace croquis::silhouette
