// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/perspective_drawing.h"

namespace croquis {

Subject stroke_subject(const PerspectiveDrawing& drawing, Index stroke);

/// Ordered by id, so that findings don't depend on the order of the drawing.
std::vector<Subject> stroke_subjects(const PerspectiveDrawing& drawing, std::span<const Index> strokes);

/// "stroke e07", "strokes e07 and e08", "strokes e07, e08 and 5 more"; ordered by id.
std::string stroke_names(const PerspectiveDrawing& drawing, std::span<const Index> strokes);

/// "x", "y" or "z".
const char* axis_name(int axis);

/// "parallel to x", "in a plane at right angles to x"; empty for unknown groups.
std::string group_words(StrokeGroup group);

}  // namespace croquis
