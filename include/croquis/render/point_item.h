// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/geometry/vector.h"
#include "croquis/render/bounds.h"
#include "croquis/render/color.h"

namespace croquis::render {

enum class PointShape { Square, Disc };

/// What covers points.
enum class PointDepth {
  OnTop,    ///< nothing
  Surfaces  ///< a surface nearer than the point's place by more than a few pixels hides the whole point
};

/// How all points of an item look. Lengths are in pixels of a screen with `RenderOptions::pixel_ratio` 1.
struct PointStyle {
  double size = 5;  ///< across, in [1, 32]
  Color color = {40, 36, 42, 255};
  Color outline = {255, 255, 255, 0};  ///< a pixel around the shape, inside `size`; alpha 0: none
  PointShape shape = PointShape::Square;
  PointDepth depth = PointDepth::Surfaces;
};

/// Points of constant size on screen: a million of them in one draw call. Symbols with a shape or a text are marks.
struct PointItem {
  glm::dvec3 origin = glm::dvec3(0);  ///< model coordinates = origin + scale * own coordinates
  double scale = 1;
  Bounds bounds;  ///< model coordinates
  PointStyle style;
  std::vector<glm::vec3> places;  ///< in the item's own frame
  std::vector<Color> colors;      ///< of each point, or empty: the style's
};

using PointItemPtr = std::shared_ptr<const PointItem>;

/// Makes points ready, later ones over earlier ones.
/// @param places model units
/// @param colors of each point, or empty
/// @throws Error (E_NOT_FINITE, malformed) naming points with a coordinate that is NaN or infinite, (E_COUNT, usage)
///         for another number of colours
/// O(points).
PointItemPtr make_point_item(std::span<const Vec3> places, const PointStyle& style = {},
                             std::span<const Color> colors = {});

/// Some of the places.
/// @param chosen indices into places
/// @throws Error as above, and (E_INDEX, malformed) for an index out of range
PointItemPtr make_point_item(std::span<const Vec3> places, std::span<const Index> chosen, const PointStyle& style = {});

}  // namespace croquis::render
