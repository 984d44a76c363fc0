// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "croquis/geometry/picture_file.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A picture behind a drawing, to trace. Nothing computes with it: it belongs to the drawing's node as its visibility
/// does, not to the drawing.
struct Backdrop {
  std::shared_ptr<const PictureFile> picture;  ///< never null; shared by all that show it
  Vec2 centre = Vec2::Zero();                  ///< on the plane that is drawn on, x right, y UP; finite
  double scale = 1;                            ///< units of the drawing per pixel of the picture, > 0
  double opacity = 1;                          ///< 0..1
  bool visible = true;

  /// Units of the drawing.
  Vec2 size() const { return scale * Vec2(picture->width, picture->height); }

  friend bool operator==(const Backdrop& a, const Backdrop& b) {
    return a.picture == b.picture && a.centre == b.centre && a.scale == b.scale && a.opacity == b.opacity &&
           a.visible == b.visible;
  }
};

/// What no backdrop has: numbers that are not finite or out of range.
bool is_valid(const Backdrop& backdrop);

}  // namespace croquis
