// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/manipulator_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

using Handle = ManipulatorHandle;

// Lengths in lengths of the handles.
constexpr double arrow_start = 0.18;
constexpr double square_near = 0.28;
constexpr double square_far = 0.48;
constexpr double view_ring = 1.2;
constexpr double free_ball = 0.9;
constexpr double head_length = 0.2;
constexpr double head_radius = 0.06;

constexpr double shortest_arrow = 0.15;  // on the screen
constexpr double thinnest_square = 0.2;  // cosine between its normal and the view
constexpr int ring_parts = 64;
constexpr double far_half = -0.02;  // cosine to the eye below which a ring's point is on the far side
constexpr double facing_ring = 0.98;

constexpr std::array<Handle, 3> axis_handles = {Handle::X, Handle::Y, Handle::Z};
constexpr std::array<Handle, 3> plane_handles = {Handle::YZ, Handle::ZX, Handle::XY};
constexpr std::array<ColourRole, 3> axis_roles = {ColourRole::X, ColourRole::Y, ColourRole::Z};

}  // namespace

int axis_of(Handle handle) {
  const auto found = std::find(axis_handles.begin(), axis_handles.end(), handle);
  return found == axis_handles.end() ? -1 : static_cast<int>(found - axis_handles.begin());
}

int normal_of(Handle handle) {
  const auto found = std::find(plane_handles.begin(), plane_handles.end(), handle);
  return found == plane_handles.end() ? -1 : static_cast<int>(found - plane_handles.begin());
}

ManipulatorShape::ManipulatorShape(const Manipulator& manipulator, const ViewFrame& frame)
    : manipulator_(manipulator), frame_(frame), eye_(frame.to_eye(manipulator.pivot)) {
  const auto middle = frame.project(manipulator.pivot);
  if (!middle) return;
  middle_ = middle->pixel;
  unit_ = manipulator.pixels * frame.units_per_pixel(manipulator.pivot);
}

bool ManipulatorShape::has_arrow(int k) const { return axis(k).cross(eye_).norm() > shortest_arrow; }

std::vector<Vec3> ManipulatorShape::arrow(int k) const {
  const Vec3& pivot = manipulator_.pivot;
  return {pivot + arrow_start * unit_ * axis(k), pivot + unit_ * axis(k)};
}

bool ManipulatorShape::has_square(int k) const { return std::abs(axis(k).dot(eye_)) > thinnest_square; }

std::vector<Vec3> ManipulatorShape::square(int k) const {
  const Vec3 a = unit_ * axis((k + 1) % 3);
  const Vec3 b = unit_ * axis((k + 2) % 3);
  std::vector<Vec3> corners;
  for (const auto& [s, t] :
       {std::pair(square_near, square_near), std::pair(square_far, square_near), std::pair(square_far, square_far),
        std::pair(square_near, square_far), std::pair(square_near, square_near)})
    corners.push_back(manipulator_.pivot + s * a + t * b);
  return corners;
}

std::vector<Vec3> ManipulatorShape::ring(int k) const {
  const bool whole = std::abs(axis(k).dot(eye_)) > facing_ring;
  // Begin in the middle of the far half, so that the near half is in one piece.
  Vec3 far = -eye_ + axis(k).dot(eye_) * axis(k);
  far = whole || far.isZero(0) ? axis((k + 1) % 3) : Vec3(far.normalized());
  const Vec3 side = axis(k).cross(far);
  std::vector<Vec3> points;
  for (int i = 0; i <= ring_parts; ++i) {
    const double angle = 2 * std::numbers::pi * i / ring_parts;
    const Vec3 direction = std::cos(angle) * far + std::sin(angle) * side;
    if (whole || direction.dot(eye_) > far_half) points.push_back(manipulator_.pivot + unit_ * direction);
  }
  return points;
}

std::vector<Vec3> ManipulatorShape::circle(double radius) const {
  std::vector<Vec3> points;
  const Vec3 right = frame_.right();
  const Vec3 up = frame_.up();
  for (int i = 0; i <= ring_parts; ++i) {
    const double angle = 2 * std::numbers::pi * i / ring_parts;
    points.push_back(manipulator_.pivot + radius * unit_ * (std::cos(angle) * right + std::sin(angle) * up));
  }
  return points;
}

double ManipulatorShape::distance(const std::vector<Vec3>& line, const Vec2& pixel) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto a = frame_.project(line[i]);
    const auto b = frame_.project(line[i + 1]);
    if (!a || !b) continue;
    const double t = nearest_parameter(pixel, a->pixel, b->pixel);
    nearest = std::min(nearest, (a->pixel + t * (b->pixel - a->pixel) - pixel).norm());
  }
  return nearest;
}

bool ManipulatorShape::holds(const std::vector<Vec3>& polygon, const Vec2& pixel) const {
  bool inside = false;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const auto a = frame_.project(polygon[i]);
    const auto b = frame_.project(polygon[i + 1]);
    if (!a || !b) return false;
    const Vec2 from = a->pixel - pixel;
    const Vec2 to = b->pixel - pixel;
    if ((from.y() > 0) != (to.y() > 0) && (cross(from, to) > 0) == (to.y() > from.y())) inside = !inside;
  }
  return inside;
}

Handle ManipulatorShape::arrow_at(const Vec2& pixel, double reach) const {
  if ((pixel - middle_).norm() <= reach) return Handle::Centre;
  for (int k = 0; k < 3; ++k) {
    if (has_square(k) && holds(square(k), pixel)) return plane_handles[static_cast<std::size_t>(k)];
  }
  Handle best = Handle::None;
  for (int k = 0; k < 3; ++k) {
    if (!has_arrow(k)) continue;
    const double away = distance(arrow(k), pixel);
    if (away > reach) continue;
    reach = away;
    best = axis_handles[static_cast<std::size_t>(k)];
  }
  return best;
}

Handle ManipulatorShape::ring_at(const Vec2& pixel, double reach) const {
  Handle best = Handle::None;
  const auto try_line = [&](const std::vector<Vec3>& line, Handle handle) {
    const double away = distance(line, pixel);
    if (away > reach) return;
    reach = away;
    best = handle;
  };
  for (int k = 0; k < 3; ++k) try_line(ring(k), axis_handles[static_cast<std::size_t>(k)]);
  try_line(circle(view_ring), Handle::View);
  if (best != Handle::None) return best;
  return (pixel - middle_).norm() <= free_ball * manipulator_.pixels ? Handle::Centre : Handle::None;
}

// ---- The picture

namespace {

class Painter {
 public:
  Painter(const Manipulator& manipulator, const ViewFrame& frame, Handle hovered, Handle active)
      : manipulator_(manipulator), shape_(manipulator, frame), hovered_(hovered), active_(active) {}

  ManipulatorPicture paint() {
    if (manipulator_.kind == ManipulatorKind::None || !shape_.visible()) return {};
    if (manipulator_.kind == ManipulatorKind::Rotate) {
      paint_rings();
    } else {
      paint_arrows();
    }
    return std::move(picture_);
  }

 private:
  HandleState state(Handle handle) const {
    if (handle == active_) return HandleState::Active;
    return handle == hovered_ && active_ == Handle::None ? HandleState::Hovered : HandleState::Normal;
  }

  void line(std::vector<Vec3> points, ColourRole role, Handle handle, bool filled = false) {
    picture_.lines.push_back({std::move(points), role, state(handle), filled});
  }

  void paint_arrows() {
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (shape_.has_square(k)) line(shape_.square(k), axis_roles[i], plane_handles[i], true);
    }
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (!shape_.has_arrow(k)) continue;
      const std::vector<Vec3> arrow = shape_.arrow(k);
      line(arrow, axis_roles[i], axis_handles[i]);
      if (manipulator_.kind == ManipulatorKind::Scale) {
        picture_.dots.push_back({arrow.back(), axis_roles[i], state(axis_handles[i]), 9, true});
      } else {
        line(head(k), axis_roles[i], axis_handles[i], true);
      }
    }
    picture_.dots.push_back({manipulator_.pivot, ColourRole::Centre, state(Handle::Centre), 11, true});
  }

  /// A triangle that faces the eye.
  std::vector<Vec3> head(int k) const {
    const Vec3 axis = manipulator_.axes.col(k);
    const Vec3 side = axis.cross(shape_.eye()).normalized() * head_radius * shape_.unit();
    const Vec3 tip = manipulator_.pivot + axis * shape_.unit();
    const Vec3 foot = tip - axis * head_length * shape_.unit();
    return {tip, foot + side, foot - side, tip};
  }

  void paint_rings() {
    line(shape_.circle(1), ColourRole::Faint, Handle::Centre);
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      line(shape_.ring(k), axis_roles[i], axis_handles[i]);
    }
    line(shape_.circle(view_ring), ColourRole::View, Handle::View);
  }

  const Manipulator& manipulator_;
  ManipulatorShape shape_;
  Handle hovered_, active_;
  ManipulatorPicture picture_;
};

}  // namespace

ManipulatorPicture picture(const Manipulator& manipulator, const ViewFrame& frame, Handle hovered, Handle active) {
  return Painter(manipulator, frame, hovered, active).paint();
}

}  // namespace croquis
