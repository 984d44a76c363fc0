// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace croquis::render {
namespace {

struct ViewAxes {
  glm::dvec3 right, up, back;
};

ViewAxes view_axes(const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(direction);
  glm::dvec3 right = glm::cross(up, back);
  // An up vector along the line of sight decides nothing: any axis across it will do.
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

/// The shape of the picture and the share of it that may be filled.
struct CanvasShape {
  double aspect = 1;
  double share = 1;
};

/// How far points reach to the four sides, in units of half the picture's height at distance 1 (or everywhere).
struct Reach {
  glm::dvec2 low = glm::dvec2(std::numeric_limits<double>::infinity());
  glm::dvec2 high = glm::dvec2(-std::numeric_limits<double>::infinity());

  void add(const glm::dvec2& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  glm::dvec2 middle() const { return 0.5 * low + 0.5 * high; }
};

glm::dvec3 seen_from(const glm::dvec3& target, const ViewAxes& axes, const glm::dvec3& point) {
  const glm::dvec3 offset = point - target;
  return {glm::dot(offset, axes.right), glm::dot(offset, axes.up), glm::dot(offset, axes.back)};
}

void frame_orthographic(std::span<const glm::dvec3> points, const ViewAxes& axes, const CanvasShape& canvas,
                        Camera& camera) {
  Reach reach;
  for (const glm::dvec3& point : points) reach.add(glm::dvec2(seen_from(camera.target, axes, point)));
  const glm::dvec2 size = reach.high - reach.low;
  camera.target += axes.right * reach.middle().x + axes.up * reach.middle().y;
  camera.height = std::max(size.y, size.x / canvas.aspect) / canvas.share;
}

/// The distance from which all points fit around the target.
double fitting_distance(std::span<const glm::dvec3> points, const ViewAxes& axes, const CanvasShape& canvas,
                        const Camera& camera) {
  const double slope = std::tan(camera.field_of_view / 2) * canvas.share;
  double distance = 0;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 place = seen_from(camera.target, axes, point);
    distance = std::max(distance, std::max(std::abs(place.x) / canvas.aspect, std::abs(place.y)) / slope + place.z);
  }
  return distance;
}

double frame_perspective(std::span<const glm::dvec3> points, const ViewAxes& axes, const CanvasShape& canvas,
                         Camera& camera) {
  double distance = fitting_distance(points, axes, canvas, camera);
  // Moving the target to the middle of what is seen changes what is seen, ever less: three rounds are within a pixel.
  for (int round = 0; round < 3; ++round) {
    Reach reach;
    for (const glm::dvec3& point : points) {
      const glm::dvec3 place = seen_from(camera.target, axes, point);
      reach.add(glm::dvec2(place) / (distance - place.z));
    }
    camera.target += distance * (axes.right * reach.middle().x + axes.up * reach.middle().y);
    distance = fitting_distance(points, axes, canvas, camera);
  }
  return distance;
}

/// @param box of the points, of some size
Camera frame_points(std::span<const glm::dvec3> points, const Bounds& box, const ViewDirection& direction,
                    const CanvasShape& canvas) {
  const ViewAxes axes = view_axes(direction.direction, direction.up);
  Camera camera;
  camera.projection = direction.projection;
  camera.target = box.center();
  camera.up = axes.up;
  double distance = 4 * box.radius();
  if (direction.projection == Projection::Perspective) {
    distance = frame_perspective(points, axes, canvas, camera);
    camera.height = 2 * distance * std::tan(camera.field_of_view / 2);
  } else {
    frame_orthographic(points, axes, canvas, camera);
    if (!(camera.height > 0)) camera.height = 2 * box.radius();  // a segment seen end on
  }
  camera.eye = camera.target + axes.back * distance;
  return camera;
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

Camera frame(std::span<const glm::dvec3> points, const ViewDirection& direction, double aspect, double margin) {
  Bounds box;
  for (const glm::dvec3& point : points) box.add(point);
  if (!(box.radius() > 0) || box.empty()) return frame(box, direction, aspect, margin);
  return frame_points(points, box, direction, {aspect, 1 - 2 * margin});
}

Camera frame(const Bounds& bounds, const ViewDirection& direction, double aspect, double margin) {
  const Bounds box = something_to_frame(bounds);
  return frame_points(box.corners(), box, direction, {aspect, 1 - 2 * margin});
}

glm::dmat4 view_matrix(const Camera& camera) {
  const ViewAxes axes = view_axes(camera.target - camera.eye, camera.up);
  const glm::dmat4 turned(glm::transpose(glm::dmat3(axes.right, axes.up, axes.back)));
  return glm::translate(turned, -camera.eye);
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
    glm::dmat4 matrix = glm::perspective(camera.field_of_view, aspect, range.near_plane, range.far_plane);
    // Clip space is two heights high; w is the distance along -z.
    matrix[2][0] = -2 * camera.principal_offset.x / aspect;
    matrix[2][1] = -2 * camera.principal_offset.y;
    return matrix;
  }
  const double half = camera.height / 2;
  return glm::ortho(-half * aspect, half * aspect, -half, half, range.near_plane, range.far_plane);
}

}  // namespace croquis::render
