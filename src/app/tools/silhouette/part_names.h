// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/operators/inflate_result.h"

namespace croquis::app {

/// What the parts of a sketch's solid are called, in the order of its objects: as people named them, or by size and
/// place as parts of a figure ("Body", "Head", "Left ear", "Leg 2", "Tail", "Eye"), else "Part 3". Which side is left
/// is the viewer's. Names depend on neither the drawing's scale nor the order of its strokes, but for numbers of parts.
std::vector<QString> part_names(const Drawing& drawing, const InflateResult& inflated);

}  // namespace croquis::app
