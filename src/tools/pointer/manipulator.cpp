// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/manipulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/geometry/polyline.h"
#include "tools/pointer/manipulator_shape.h"
#include "tools/pointer/pointer_place.h"

namespace croquis {
namespace {

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

}  // namespace croquis
