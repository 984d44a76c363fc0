// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/render/bounds.h"
#include "croquis/render/color.h"

namespace croquis::render {

/// Symbols that stand at a place of the model and keep their size on screen.
enum class MarkShape : std::uint8_t {
  Disc,      ///< a point
  Ring,      ///< a circle of the mark's colour, open inside
  Square,    ///< an anchor
  Cross,     ///< something wrong: x
  Warning,   ///< a triangle with an exclamation mark
  OverUnder  ///< two bars that cross: the upper one runs through, the lower one stops at either side of it
};

/// A symbol. Lengths are in pixels of a screen with `RenderOptions::pixel_ratio` 1, angles in radians on the screen,
/// counterclockwise from the right.
struct Mark {
  glm::dvec3 position = glm::dvec3(0);  ///< model units; the symbol's middle stands there
  MarkShape shape = MarkShape::Disc;
  float size = 8;  ///< across, in (0, 256], without outline and halo
  Color color = {40, 36, 42, 255};
  Color outline = {255, 255, 255, 255};  ///< around the shape, to part it from what is behind; alpha 0: none
  float outline_width = 1;
  float angle = 0;                          ///< turns the shape; OverUnder: where the upper bar points
  float under_angle = 1.5707963267948966F;  ///< OverUnder: where the lower bar points
  Color halo = {0, 0, 0, 0};                ///< outside the outline, for hover and the like; alpha 0: none
  float halo_width = 4;
};

/// A mark as the graphics card takes it.
struct MarkVertex {
  glm::vec3 position;  ///< in the item's own frame
  float size;
  float outline_width;
  float halo_width;
  float angle;
  float under_angle;
  Color color;
  Color outline;
  Color halo;
  std::uint32_t shape;
};

/// What covers marks.
enum class MarkDepth {
  OnTop,  ///< nothing
  Tested  ///< a surface nearer than the mark's place hides the whole mark
};

/// Marks ready to be drawn, later ones over earlier ones: never changed once made.
struct MarkItem {
  glm::dvec3 origin = glm::dvec3(0);  ///< model coordinates = origin + scale * own coordinates
  double scale = 1;
  Bounds bounds;  ///< of the places, model coordinates
  MarkDepth depth = MarkDepth::OnTop;
  std::vector<MarkVertex> marks;
};

using MarkItemPtr = std::shared_ptr<const MarkItem>;

/// Makes marks ready.
/// @throws Error (E_NOT_FINITE, malformed) naming each mark with a coordinate, length or angle that is NaN or infinite
/// O(marks).
MarkItemPtr make_mark_item(std::span<const Mark> marks, MarkDepth depth = MarkDepth::OnTop);

}  // namespace croquis::render
