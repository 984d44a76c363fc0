// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/tools/silhouette/stroke_edit.h"

/// Taking pieces out of strokes with a round eraser that is moved along a path.
namespace croquis {

/// What an eraser covers of the strokes: open polylines, sketch units.
/// @param path #P by 2, sketch units; @param radius of the eraser, sketch units, >= 0
std::vector<std::vector<Vec2>> erased_pieces(const Drawing& drawing, const std::vector<Vec2>& path, double radius);

/// Cuts what an eraser covers out of the strokes: `changed` are shorter now, and open; what else is left of them is
/// `added` right after them, with the same data. A rest shorter than the eraser is wide goes as well, and a stroke of
/// which less than a tenth would be left is `removed`. What is left keeps its samples; the cuts get new ones. Strokes
/// that pass behind one that fell apart pass behind all its pieces.
DrawingEdit erase_along(const Drawing& drawing, const std::vector<Vec2>& path, double radius);

}  // namespace croquis
