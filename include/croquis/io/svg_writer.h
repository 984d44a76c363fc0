// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/drawing.h"

namespace croquis {

/// An SVG file of the drawing: one path of straight pieces per stroke, with its id and its data as data-* attributes,
/// in a group with `data-object` where it was forced into an object; `data-plane` of the root where it doesn't lie at z
/// = 0; hidden ones (data "visible" = "false") are dashed so that the file is legible in any viewer. y is flipped back
/// down, numbers read back exactly.
std::string write_svg_drawing(const Drawing& drawing);

}  // namespace croquis
