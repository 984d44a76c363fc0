// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// A place of the model dragged by the pointer: in the plane across the view, or along a line.
class PatchDrag {
 public:
  /// @param grip where the pointer was pressed, near the place. @param axis unit; none: across the view
  PatchDrag(const ViewFrame& frame, const Vec2& grip, const Vec3& from, const std::optional<Vec3>& axis);

  Vec3 to(const Vec2& pixel) const;

 private:
  double along_axis(const Vec2& pixel) const;

  ViewFrame frame_;
  Vec2 grip_;
  Vec3 from_;
  std::optional<Vec3> axis_;
  bool end_on_ = false;  ///< the axis points to the eye: up and down move along it
};

}  // namespace croquis
