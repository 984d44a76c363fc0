// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/manipulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "croquis/geometry/polyline.h"

/// Where a pointer is along an axis or in a plane, so that what it holds stays under it in every view, perspective or
/// parallel, wherever the view's near and far planes are. Towards the horizon places end where things would look a
/// hundred times smaller. O(1).

namespace croquis {
namespace {

/// Where a manipulator's handles are in one view. Both the picture and the picking are made of it.
class ManipulatorShape {
 public:
  ManipulatorShape(const Manipulator& manipulator, const ViewFrame& frame);

  /// Whether the view shows it at all.
  bool visible() const { return unit_ > 0; }

  /// Axes that point into the view have no arrow there.
  bool has_arrow(int axis) const;
  std::vector<Vec3> arrow(int axis) const;  ///< from near the middle to the tip

  /// Planes seen from their edge have no square there.
  bool has_square(int normal) const;
  std::vector<Vec3> square(int normal) const;  ///< closed

  /// The near half of the ring about an axis, or all of one that faces the eye.
  std::vector<Vec3> ring(int axis) const;
  std::vector<Vec3> circle(double radius) const;  ///< facing the eye, closed; in lengths of the handles

  ManipulatorHandle arrow_at(const Vec2& pixel, double reach) const;
  ManipulatorHandle ring_at(const Vec2& pixel, double reach) const;

  double unit() const { return unit_; }  ///< length of the handles, model units
  const Vec3& eye() const { return eye_; }

 private:
  double distance(const std::vector<Vec3>& line, const Vec2& pixel) const;
  bool holds(const std::vector<Vec3>& polygon, const Vec2& pixel) const;
  Vec3 axis(int k) const { return manipulator_.axes.col(k); }

  const Manipulator& manipulator_;
  const ViewFrame& frame_;
  double unit_ = 0;
  Vec3 eye_ = Vec3::UnitZ();    ///< unit direction to the eye
  Vec2 middle_ = Vec2::Zero();  ///< the pivot's pixel
};

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

/// 0, 1, 2 of a handle along or about an axis, else -1.
int axis_of(Handle handle) {
  const auto found = std::find(axis_handles.begin(), axis_handles.end(), handle);
  return found == axis_handles.end() ? -1 : static_cast<int>(found - axis_handles.begin());
}

/// Of a handle in a plane the axis across it, else -1.
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

constexpr double least_looks = 0.01;  // how much smaller things may come to look towards the horizon

/// A clip position as pixels, y down, that are still to be divided by its w.
Vec2 undivided_pixel(const ViewFrame& frame, const Eigen::Vector4d& clip) {
  return Vec2(clip.x(), -clip.y()).cwiseProduct(frame.size / 2);
}

/// How far from a place along an axis that is seen lies which is nearest to the pixel on the screen, model units; 0
/// where the axis points straight into the view.
/// @param place in front of the eye. @param axis unit
double pointer_on_axis(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& axis) {
  const auto seen = frame.project(place);
  if (!seen) return 0;
  const Eigen::Vector4d start = frame.to_clip.leftCols<3>() * place + frame.to_clip.col(3);
  const Eigen::Vector4d step = frame.to_clip.leftCols<3>() * axis;
  // On the screen the place t along the axis is t · way / (w (w + t step.w)) away from the start.
  const Vec2 way = undivided_pixel(frame, step) * start.w() - undivided_pixel(frame, start) * step.w();
  const double length = way.norm();
  if (!(length > 0)) return 0;
  const double pulled = (pixel - seen->pixel).dot(way) / length;
  const double looks = 1 - pulled * start.w() * step.w() / length;  // w / (w + t step.w)
  const double nearest_horizon = looks < least_looks ? (1 - least_looks) / (1 - looks) : 1;
  return nearest_horizon * pulled * start.w() * start.w() / (length * std::max(looks, least_looks));
}

/// The place of the plane that is seen at the pixel; nothing when the plane is seen from its edge.
/// @param place of the plane, in front of the eye. @param normal unit
std::optional<Vec3> pointer_on_plane(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& normal) {
  const auto seen = frame.project(place);
  if (!seen) return std::nullopt;
  const auto met = [&](const Vec2& at) -> std::optional<Vec3> {
    const Ray sight = frame.sight(at);
    const double distance = (place - sight.origin).dot(normal) / sight.direction.dot(normal);
    if (!std::isfinite(distance)) return std::nullopt;
    return sight.at(distance);
  };
  if (!frame.perspective()) return met(pixel);
  const Ray sight = frame.sight(pixel);
  const Eigen::RowVector4d depth = frame.to_clip.row(3);
  const double away = (place - sight.origin).dot(normal);
  if (away == 0) return std::nullopt;
  // Over a plane, 1 / w changes evenly along the screen: up to the horizon, where it is 0.
  const double looks = (depth.head<3>().dot(place) + depth[3]) * sight.direction.dot(normal) /
                       (away * depth.head<3>().dot(sight.direction));
  if (looks >= least_looks) return met(pixel);
  return met(seen->pixel + (1 - least_looks) / (1 - looks) * (pixel - seen->pixel));
}

using Handle = ManipulatorHandle;

constexpr double degree = std::numbers::pi / 180;
constexpr double least_factor = 0.001;   // nothing is scaled flat or turned inside out by a drag
constexpr double flattest_plane = 0.08;  // cosine between a plane's normal and the view below which places slip away
constexpr double steepest_ring = 0.2;    // cosine below which a ring is turned by pulling along it

double snapped(double value, double step) { return step > 0 ? std::round(value / step) * step : value; }

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// How far along an axis through the pivot a pixel lies, model units.
double along_axis(const Manipulator& manipulator, const ViewFrame& frame, const Vec2& pixel, const Vec3& axis) {
  if (frame.to_eye(manipulator.pivot).cross(axis).norm() < flattest_plane) {
    // It points into the view: up on the screen is along it.
    return -pixel.y() * frame.units_per_pixel(manipulator.pivot);
  }
  return pointer_on_axis(frame, pixel, manipulator.pivot, axis);
}

Eigen::Affine3d about(const Vec3& pivot, const Eigen::Matrix3d& linear) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() = linear;
  map.translation() = pivot - linear * pivot;
  return map;
}

}  // namespace

// ---- Which handle

Handle handle_at(const Manipulator& manipulator, const ViewFrame& frame, const Vec2& pixel, double reach) {
  if (manipulator.kind == ManipulatorKind::None) return Handle::None;
  const ManipulatorShape shape(manipulator, frame);
  if (!shape.visible()) return Handle::None;
  if (manipulator.kind == ManipulatorKind::Rotate) return shape.ring_at(pixel, reach);
  return shape.arrow_at(pixel, reach);
}

// ---- Dragging

ManipulatorDrag::ManipulatorDrag(const Manipulator& manipulator, Handle handle, const Vec2& pixel)
    : manipulator_(manipulator), handle_(handle), start_(pixel), last_(pixel) {}

const ManipulatorMotion& ManipulatorDrag::to(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap) {
  if (!pixel.allFinite() || !frame.project(manipulator_.pivot)) return motion_;
  if (manipulator_.kind == ManipulatorKind::Move) move(frame, pixel, snap);
  if (manipulator_.kind == ManipulatorKind::Scale) scale(frame, pixel, snap);
  if (manipulator_.kind == ManipulatorKind::Rotate) {
    if (handle_ == Handle::Centre) {
      turn_freely(frame, pixel);
    } else {
      turn(frame, pixel, snap);
    }
  }
  last_ = pixel;
  return motion_;
}

void ManipulatorDrag::move(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap) {
  const Eigen::Matrix3d& axes = manipulator_.axes;
  Vec3 by = Vec3::Zero();  // along the axes
  if (const int axis = axis_of(handle_); axis >= 0) {
    const double now = along_axis(manipulator_, frame, pixel, axes.col(axis));
    const double before = along_axis(manipulator_, frame, start_, axes.col(axis));
    by[axis] = snapped(now - before, snap.move);
  } else if (const int normal = normal_of(handle_); normal >= 0) {
    if (std::abs(frame.to_eye(manipulator_.pivot).dot(axes.col(normal))) < flattest_plane) return;
    const auto now = pointer_on_plane(frame, pixel, manipulator_.pivot, axes.col(normal));
    const auto before = pointer_on_plane(frame, start_, manipulator_.pivot, axes.col(normal));
    if (!now || !before) return;
    by = axes.transpose() * (*now - *before);
    by[normal] = 0;
    for (double& part : by) part = snapped(part, snap.move);
  } else {
    const double depth = frame.project(manipulator_.pivot)->depth;
    by = axes.transpose() * (frame.unproject(pixel, depth) - frame.unproject(start_, depth));
  }
  motion_.by = axes * by;
  motion_.map = Eigen::Translation3d(motion_.by);
}

void ManipulatorDrag::turn(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap) {
  const Vec3& pivot = manipulator_.pivot;
  const Vec3 eye = frame.to_eye(pivot);
  const int index = axis_of(handle_);
  const Vec3 axis = index >= 0 ? Vec3(manipulator_.axes.col(index)) : eye;
  const double facing = axis.dot(eye);
  const Vec2 middle = frame.project(pivot)->pixel;
  const auto on_screen = [&](const Vec2& at) { return std::atan2(middle.y() - at.y(), at.x() - middle.x()); };
  if (index < 0) {
    if (pixel != middle && last_ != middle) turned_ += wrapped(on_screen(pixel) - on_screen(last_));
  } else if (std::abs(facing) >= steepest_ring) {
    const auto now = pointer_on_plane(frame, pixel, pivot, axis);
    const auto before = pointer_on_plane(frame, last_, pivot, axis);
    if (!now || !before) return;
    const Vec3 from = *before - pivot;
    const Vec3 to = *now - pivot;
    turned_ += std::atan2(axis.dot(from.cross(to)), from.dot(to));
  } else {
    // Seen from its edge, the near side of the ring runs along axis × eye.
    const Vec3 along = axis.cross(eye);
    const auto tip = frame.project(pivot + along * frame.units_per_pixel(pivot) * manipulator_.pixels);
    if (!tip || tip->pixel == middle) return;
    turned_ += (pixel - last_).dot((tip->pixel - middle).normalized()) / manipulator_.pixels;
  }
  motion_.axis = axis;
  motion_.degrees = snapped(turned_ / degree, snap.degrees);
  motion_.map = about(pivot, Eigen::AngleAxisd(motion_.degrees * degree, axis).toRotationMatrix());
}

void ManipulatorDrag::turn_freely(const ViewFrame& frame, const Vec2& pixel) {
  const Vec2 pulled = pixel - start_;
  const Vec3 axis = frame.up() * pulled.x() + frame.right() * pulled.y();
  if (axis.isZero(0)) {
    motion_ = {};
    return;
  }
  motion_.axis = axis.normalized();
  motion_.degrees = pulled.norm() / manipulator_.pixels / degree;
  motion_.map = about(manipulator_.pivot, Eigen::AngleAxisd(motion_.degrees * degree, motion_.axis).toRotationMatrix());
}

void ManipulatorDrag::scale(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap) {
  const Eigen::Matrix3d& axes = manipulator_.axes;
  const double unit = frame.units_per_pixel(manipulator_.pivot) * manipulator_.pixels;
  double grown = (pixel.x() - start_.x()) / manipulator_.pixels;
  const int axis = axis_of(handle_);
  const int normal = normal_of(handle_);
  if (axis >= 0 || normal >= 0) {
    Vec3 along = axis >= 0 ? Vec3(axes.col(axis)) : Vec3(axes.col((normal + 1) % 3) + axes.col((normal + 2) % 3));
    along.normalize();
    if (!(unit > 0)) return;
    grown = (along_axis(manipulator_, frame, pixel, along) - along_axis(manipulator_, frame, start_, along)) / unit;
  }
  const double factor = std::max(least_factor, snapped(1 + grown, snap.scale));
  for (int k = 0; k < 3; ++k) {
    const bool grows = axis >= 0 ? k == axis : k != normal;
    motion_.factors[k] = grows ? factor : 1;
  }
  motion_.map = about(manipulator_.pivot, axes * motion_.factors.asDiagonal() * axes.transpose());
}

Manipulator ManipulatorDrag::moved() const {
  Manipulator now = manipulator_;
  now.pivot += motion_.by;
  if (now.kind == ManipulatorKind::Rotate) now.axes = motion_.map.linear() * now.axes;
  return now;
}

ManipulatorPicture picture(const Manipulator& manipulator, const ViewFrame& frame, Handle hovered, Handle active) {
  return Painter(manipulator, frame, hovered, active).paint();
}

}  // namespace croquis
