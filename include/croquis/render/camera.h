// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/glm.hpp>

#include "croquis/render/bounds.h"

namespace croquis::render {

enum class Projection { Orthographic, Perspective };

/// Where the picture is taken from: a plain value in model units, right-handed, with x to the right and y up on screen.
struct Camera {
  Projection projection = Projection::Orthographic;
  glm::dvec3 eye = {0, 0, 1};
  glm::dvec3 target = {0, 0, 0};  ///< what stands in the middle of the picture; differs from eye
  glm::dvec3 up = {0, 1, 0};      ///< any length, not along the line of sight
  double height = 2;              ///< orthographic only: model units from the picture's lower to its upper border, > 0
  double field_of_view = 0.5;     ///< perspective only: vertical opening in radians, in (0, pi)
  /// Perspective only: where the line of sight meets the picture, from its middle, × the picture's height; x to the
  /// right, y up. Pictures that are a part of a larger one are seen off the axis.
  glm::dvec2 principal_offset = {0, 0};

  bool operator==(const Camera&) const = default;
};

/// How a camera looks at things before it knows how large they are.
struct ViewDirection {
  glm::dvec3 direction = {0, 0, -1};  ///< from the eye into the scene, any length but 0
  glm::dvec3 up = {0, 1, 0};
  Projection projection = Projection::Orthographic;
};

/// The views that people ask for by name.
enum class NamedView {
  Front,       ///< orthographic, from +z: x right, y up
  Side,        ///< orthographic, from +x: -z right, y up
  Top,         ///< orthographic, from +y: x right, -z up
  Perspective  ///< three-quarter view from the right, above and in front
};

ViewDirection view_direction(NamedView view);

/// The camera of that direction that shows the whole box in the middle, as large as fits.
///
/// @param bounds an empty box counts as the cube [-1,1]^3, a single point as a box of side 2 about it
/// @param aspect width / height of the picture, > 0
/// @param margin share of the picture's width and height left free on each border, in [0, 0.5)
Camera frame(const Bounds& bounds, const ViewDirection& direction, double aspect, double margin = 0.06);

/// The same about points (`points_of` items): closer than about their box wherever they leave its corners empty.
Camera frame(std::span<const glm::dvec3> points, const ViewDirection& direction, double aspect, double margin = 0.06);

/// Model to view space: x right, y up, looking along -z, in model units.
glm::dmat4 view_matrix(const Camera& camera);

/// Distances from the eye along the line of sight between which things are drawn, in model units.
struct DepthRange {
  double near_plane = 0.1;
  double far_plane = 10;
};

/// A range that holds the box; in perspective its near plane is positive.
DepthRange depth_range(const Camera& camera, const Bounds& bounds);

/// View space to clip space with OpenGL's depth of [-1, 1].
glm::dmat4 projection_matrix(const Camera& camera, double aspect, const DepthRange& range);

}  // namespace croquis::render
