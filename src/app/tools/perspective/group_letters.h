// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/render/line_item.h"

/// The letters that stand beside strokes and name their groups.
namespace croquis::app {

/// A letter's middle, px of the sheet.
struct GroupLetter {
  StrokeGroup group = StrokeGroup::Unknown;
  Vec2 at = Vec2::Zero();
};

/// A place beside each stroke that is long enough, where no other letter stands; strokes that have none go without one,
/// construction lines before edges. O(#letters²), 60 strokes in well under a millisecond.
/// @param unit px of the sheet per logical pixel of the view, > 0
std::vector<GroupLetter> group_letters(const PerspectiveDrawing& drawing, double unit);

/// The letters with the sheet's colour around them, so that they are read over strokes and pictures of any colour.
std::vector<render::LineItemPtr> letter_items(const std::vector<GroupLetter>& letters, double unit);

}  // namespace croquis::app
