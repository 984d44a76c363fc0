// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "croquis/render/camera.h"

/// Moving a camera and asking it what is where: pure functions.
///
/// Pixels count from the view's upper left corner, x to the right and y down, as pointer events do; any unit of pixels
/// serves as long as the view's size is in the same. Sizes are (width, height), both > 0.
namespace croquis::render {

/// Turns the camera about a point that keeps its place on screen, like a turntable: what is upright stays upright.
/// @param turn radians: x > 0 turns the model to the right about the vertical axis, y > 0 tips its top towards the eye
///        (the camera rises); it stops when looking straight down or up instead of going over
Camera tumble(const Camera& camera, const glm::dvec3& pivot, const glm::dvec2& turn);

/// Moves the camera sideways so that what is at the target's distance follows the pointer.
/// @param pixels how far the pointer moved, y down
Camera track(const Camera& camera, const glm::dvec2& pixels, double view_height);

/// Comes nearer (factor > 1) or goes away (in (0, 1)); the target keeps its place. Other factors change nothing.
Camera dolly(const Camera& camera, double factor);

/// The same, but a model point keeps its place on screen.
Camera dolly_about(const Camera& camera, double factor, const glm::dvec3& anchor);

/// The same, but what is under the pixel at the target's distance stays under it.
Camera dolly_about(const Camera& camera, double factor, const glm::dvec2& pixel, const glm::dvec2& view_size);

/// A line of sight: eye (or, in parallel views, a place beside it) and direction of length 1.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

/// What a pixel looks along.
Ray ray_at(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& view_size);

/// The model point under a pixel at the target's distance.
glm::dvec3 point_at_target(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& view_size);

/// Where a model point is seen; none when it is not in front of a perspective eye. Inverts the functions above.
std::optional<glm::dvec2> project(const Camera& camera, const glm::dvec3& point, const glm::dvec2& view_size);

/// Model units that a pixel spans across the line of sight at the point's distance.
double units_per_pixel(const Camera& camera, const glm::dvec3& point, double view_height);

}  // namespace croquis::render
