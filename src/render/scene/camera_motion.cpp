// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/camera_motion.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace croquis::render {
namespace {

/// The rows of the view's rotation.
struct Axes {
  glm::dvec3 right, up, back;
};

Axes axes_of(const Camera& camera) {
  const glm::dmat3 rows = glm::transpose(glm::dmat3(view_matrix(camera)));
  return {rows[0], rows[1], rows[2]};
}

/// Half the view's height at distance 1 from a perspective eye, or anywhere in a parallel view.
double half_height(const Camera& camera) {
  return camera.projection == Projection::Perspective ? std::tan(camera.field_of_view / 2) : camera.height / 2;
}

double distance_ahead(const Camera& camera, const glm::dvec3& point) {
  return glm::dot(point - camera.eye, glm::normalize(camera.target - camera.eye));
}

/// From the view's middle, x right and y up, in half view heights.
glm::dvec2 from_middle(const glm::dvec2& pixel, const glm::dvec2& view_size) {
  const glm::dvec2 offset = pixel - 0.5 * view_size;
  return 2.0 * glm::dvec2(offset.x, -offset.y) / view_size.y;
}

/// Where the line of sight meets the picture, in half view heights.
glm::dvec2 principal_place(const Camera& camera) {
  return camera.projection == Projection::Perspective ? 2.0 * camera.principal_offset : glm::dvec2(0);
}

Camera moved(const Camera& camera, const glm::dvec3& way) {
  Camera result = camera;
  result.eye += way;
  result.target += way;
  return result;
}

glm::dvec3 turned_about(const glm::dvec3& pivot, const glm::dmat3& rotation, const glm::dvec3& point) {
  return pivot + rotation * (point - pivot);
}

glm::dmat3 rotation_about(const glm::dvec3& axis, double angle) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis));
}

constexpr glm::dvec3 vertical = {0, 1, 0};

bool usable(double factor) { return std::isfinite(factor) && factor > 0; }

}  // namespace

Camera tumble(const Camera& camera, const glm::dvec3& pivot, const glm::dvec2& turn) {
  const Axes axes = axes_of(camera);
  // The camera's own up gives the eye's elevation even where its line of sight is vertical.
  const double elevation = std::atan2(axes.back.y, axes.up.y);
  const double limit = std::max(M_PI / 2, std::abs(elevation));  // a camera that hangs over stays where it is
  const double rise = std::clamp(elevation + turn.y, -limit, limit) - elevation;
  const glm::dmat3 rotation = rotation_about(vertical, -turn.x) * rotation_about(axes.right, -rise);
  Camera result = camera;
  result.eye = turned_about(pivot, rotation, camera.eye);
  result.target = turned_about(pivot, rotation, camera.target);
  result.up = glm::normalize(rotation * axes.up);
  return result;
}

Camera track(const Camera& camera, const glm::dvec2& pixels, double view_height) {
  const Axes axes = axes_of(camera);
  const double unit = units_per_pixel(camera, camera.target, view_height);
  return moved(camera, unit * (pixels.y * axes.up - pixels.x * axes.right));
}

Camera dolly(const Camera& camera, double factor) {
  return usable(factor) ? dolly_about(camera, factor, camera.target) : camera;
}

Camera dolly_about(const Camera& camera, double factor, const glm::dvec3& anchor) {
  if (!usable(factor)) return camera;
  Camera result = camera;
  if (camera.projection == Projection::Perspective) {
    // Everything shrinks towards the anchor: lines of sight through it keep their direction.
    result.eye = anchor + (camera.eye - anchor) / factor;
    result.target = anchor + (camera.target - anchor) / factor;
    return result;
  }
  result.height /= factor;
  const Axes axes = axes_of(camera);
  const glm::dvec3 offset = (anchor - camera.target) * (1 - 1 / factor);
  return moved(result, axes.right * glm::dot(offset, axes.right) + axes.up * glm::dot(offset, axes.up));
}

Camera dolly_about(const Camera& camera, double factor, const glm::dvec2& pixel, const glm::dvec2& view_size) {
  return dolly_about(camera, factor, point_at_target(camera, pixel, view_size));
}

Ray ray_at(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& view_size) {
  const Axes axes = axes_of(camera);
  const glm::dvec2 place = half_height(camera) * (from_middle(pixel, view_size) - principal_place(camera));
  const glm::dvec3 sideways = place.x * axes.right + place.y * axes.up;
  if (camera.projection == Projection::Perspective) return {camera.eye, glm::normalize(sideways - axes.back)};
  return {camera.eye + sideways, -axes.back};
}

glm::dvec3 point_at_target(const Camera& camera, const glm::dvec2& pixel, const glm::dvec2& view_size) {
  const Ray ray = ray_at(camera, pixel, view_size);
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
  return ray.origin + ray.direction * (glm::distance(camera.eye, camera.target) / glm::dot(ray.direction, ahead));
}

std::optional<glm::dvec2> project(const Camera& camera, const glm::dvec3& point, const glm::dvec2& view_size) {
  const Axes axes = axes_of(camera);
  const glm::dvec3 offset = point - camera.eye;
  glm::dvec2 place(glm::dot(offset, axes.right), glm::dot(offset, axes.up));
  if (camera.projection == Projection::Perspective) {
    const double ahead = -glm::dot(offset, axes.back);
    if (!(ahead > 0)) return std::nullopt;
    place /= ahead;
  }
  place = place / half_height(camera) + principal_place(camera);
  return 0.5 * view_size + 0.5 * view_size.y * glm::dvec2(place.x, -place.y);
}

double units_per_pixel(const Camera& camera, const glm::dvec3& point, double view_height) {
  const double height = 2 * half_height(camera);
  if (camera.projection == Projection::Orthographic) return height / view_height;
  return height * std::max(0.0, distance_ahead(camera, point)) / view_height;
}

}  // namespace croquis::render
