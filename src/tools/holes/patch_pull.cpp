// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/holes/patch_pull.h"

#include <cmath>

namespace croquis {
namespace {

/// Cosine between axis and line of sight (10 degrees): nearer to it the pointer's place on the axis is
/// random.
constexpr double end_on_cosine = 0.985;

}  // namespace

PatchDrag::PatchDrag(const ViewFrame& frame, const Vec2& grip, const Vec3& from, const std::optional<Vec3>& axis)
    : frame_(frame), grip_(grip), from_(from), axis_(axis) {
  end_on_ = axis && std::abs(axis->dot(frame.to_eye(from))) > end_on_cosine;
}

Vec3 PatchDrag::to(const Vec2& pixel) const {
  if (axis_) return from_ + (along_axis(pixel) - along_axis(grip_)) * *axis_;
  const auto at = frame_.project(from_);
  return at ? frame_.unproject(at->pixel + pixel - grip_, at->depth) : from_;
}

double PatchDrag::along_axis(const Vec2& pixel) const {
  if (end_on_) {
    const double towards_eye = axis_->dot(frame_.to_eye(from_)) < 0 ? -1 : 1;
    return towards_eye * (grip_.y() - pixel.y()) * frame_.units_per_pixel(from_);
  }
  // The place of the axis that the pixel's ray passes nearest to.
  const Ray ray = frame_.ray(pixel);
  const double cosine = ray.direction.dot(*axis_);
  const Vec3 apart = ray.origin - from_;
  const double sine_squared = 1 - cosine * cosine;
  if (!(sine_squared > 0)) return 0;
  return (axis_->dot(apart) - cosine * ray.direction.dot(apart)) / sine_squared;
}

}  // namespace croquis
