// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace croquis::render {
namespace {

struct ViewAxes {
  glm::dvec3 right, up, back;
};

ViewAxes view_axes(const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(direction);
  glm::dvec3 right = glm::cross(up, back);
  // An up vector along the line of sight says nothing: any axis across it serves.
  if (glm::length(right) < 1e-9 * glm::length(up)) {
    right = glm::cross(std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1), back);
  }
  right = glm::normalize(right);
  return {right, glm::cross(back, right), back};
}

Bounds something_to_frame(const Bounds& bounds) {
  Bounds box = bounds;
  if (box.empty()) box.add(glm::dvec3(0));
  if (box.radius() > 0) return box;
  // One unit, or as much as still changes a point far from the origin.
  const double half = std::max(1.0, glm::length(box.center()) * 1e-6);
  return {box.center() - glm::dvec3(half), box.center() + glm::dvec3(half)};
}

}  // namespace

ViewDirection view_direction(NamedView view) {
  switch (view) {
    case NamedView::Front: return {{0, 0, -1}, {0, 1, 0}, Projection::Orthographic};
    case NamedView::Side: return {{-1, 0, 0}, {0, 1, 0}, Projection::Orthographic};
    case NamedView::Top: return {{0, -1, 0}, {0, 0, -1}, Projection::Orthographic};
    case NamedView::Perspective: return {{-0.62, -0.46, -1.0}, {0, 1, 0}, Projection::Perspective};
  }
  return {};
}

Camera frame(const Bounds& bounds, const ViewDirection& direction, double aspect, double margin) {
  const Bounds box = something_to_frame(bounds);
  const ViewAxes axes = view_axes(direction.direction, direction.up);
  Camera camera;
  camera.projection = direction.projection;
  camera.target = box.center();
  camera.up = axes.up;
  const double share = 1 - 2 * margin;
  const double tan_y = std::tan(camera.field_of_view / 2) * share;
  double height = 0;
  double distance = 0;
  for (const glm::dvec3& corner : box.corners()) {
    const glm::dvec3 offset = corner - camera.target;
    const double x = std::abs(glm::dot(offset, axes.right)) / aspect;
    const double y = std::abs(glm::dot(offset, axes.up));
    height = std::max(height, 2 * std::max(x, y) / share);
    distance = std::max(distance, std::max(x, y) / tan_y + glm::dot(offset, axes.back));
  }
  camera.height = height > 0 ? height : 2 * box.radius();  // a segment seen end on
  if (direction.projection == Projection::Orthographic) distance = 4 * box.radius();
  camera.eye = camera.target + axes.back * distance;
  return camera;
}

glm::dmat4 view_matrix(const Camera& camera) {
  const ViewAxes axes = view_axes(camera.target - camera.eye, camera.up);
  return glm::lookAt(camera.eye, camera.eye - axes.back, axes.up);
}

DepthRange depth_range(const Camera& camera, const Bounds& bounds) {
  const Bounds box = something_to_frame(bounds);
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  // The sphere about the box, a little larger: turning the camera does not move the planes.
  const double radius = 1.01 * box.radius();
  const double middle = glm::dot(box.center() - camera.eye, forward);
  DepthRange range{middle - radius, middle + radius};
  if (camera.projection == Projection::Perspective) {
    range.far_plane = std::max(range.far_plane, 1e-3 * radius);
    // With the eye inside the box, a thousandth of its size keeps enough bits of depth.
    range.near_plane = std::max(range.near_plane, 1e-3 * range.far_plane);
    range.far_plane = std::max(range.far_plane, 2 * range.near_plane);
  }
  return range;
}

glm::dmat4 projection_matrix(const Camera& camera, double aspect, const DepthRange& range) {
  if (camera.projection == Projection::Perspective) {
    return glm::perspective(camera.field_of_view, aspect, range.near_plane, range.far_plane);
  }
  const double half = camera.height / 2;
  return glm::ortho(-half * aspect, half * aspect, -half, half, range.near_plane, range.far_plane);
}

}  // namespace croquis::render
