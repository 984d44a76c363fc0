// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/operators/inflate_result.h"

namespace croquis {

enum class PartRole { None, Body, Head, Ear, Eye, Arm, Leg, Tail };

struct PartPlace {
  PartRole role = PartRole::None;
  Vec2 middle = Vec2::Zero();  ///< of the box around its strokes
};

/// Which parts of a figure the parts of a sketch's solid look like, by their sizes, places and joints, in the order of
/// its objects. Depends on neither the drawing's scale nor the order of its strokes.
std::vector<PartPlace> part_roles(const Drawing& drawing, const InflateResult& inflated);

}  // namespace croquis
