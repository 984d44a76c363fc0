// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/camera_estimation.h"

namespace croquis {

/// Pictures of any size in one unit, u, around their centre, so that thresholds and rounding are the same for all.
struct SheetFrame {
  Vec2 centre = Vec2::Zero();  ///< px
  double unit = 1;             ///< px per u

  explicit SheetFrame(const PerspectiveDrawing& drawing)
      : centre(drawing.centre()), unit(drawing.diagonal() / sheet_units_per_diagonal) {}

  Vec2 to_sheet(const Vec2& px) const { return (px - centre) / unit; }
  Vec2 to_picture(const Vec2& sheet) const { return centre + unit * sheet; }
};

}  // namespace croquis
