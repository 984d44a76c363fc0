// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/tools/pointer/pick_box.h"

/// What lies under the pointer on the sheet of a perspective drawing. Places and reaches are px of the sheet.
namespace croquis {

/// The stroke nearest to a place, within reach; of equally near ones the one drawn last. Linear.
std::optional<std::string> nearest_stroke(const PerspectiveDrawing& drawing, const Vec2& place, double reach);

/// A point of a stroke that can be dragged (see points_of).
struct PickedPoint {
  std::string stroke;
  std::size_t point = 0;
  friend bool operator==(const PickedPoint&, const PickedPoint&) = default;
};

/// The nearest one of the strokes named, within reach; ends before handles that lie as near.
std::optional<PickedPoint> nearest_point(const PerspectiveDrawing& drawing, const std::vector<std::string>& ids,
                                         const Vec2& place, double reach);

/// Ids of the strokes that lie in the box with some part, in the drawing's order.
std::vector<std::string> strokes_in_box(const PerspectiveDrawing& drawing, const PickBox& box);

/// Ids of the strokes that the tip of an eraser touches on its way, in the drawing's order.
std::vector<std::string> strokes_touched(const PerspectiveDrawing& drawing, const Vec2& from, const Vec2& to,
                                         double radius);

/// Of loops of strokes, as they are drawn, the smallest one that a place lies in. The strokes of a loop may come in any
/// order and direction; what isn't a loop is passed over.
std::optional<std::size_t> face_at(const PerspectiveDrawing& drawing,
                                   const std::vector<std::vector<std::string>>& loops, const Vec2& place);

}  // namespace croquis
