// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/arc_length_curve.h"

#include <algorithm>
#include <array>
#include <utility>

#include "arc_lengths.h"
#include "bezier.h"
#include "piecewise_quintic.h"

namespace croquis {

/// The curve's parameter as a function of the arc-length fraction.
class CurveParameterTable {
 public:
  explicit CurveParameterTable(const std::vector<Vec3>& control)
      : derivative_(bezier_derivative(control)),
        lengths_(control),
        table_([this](double s) { return Scalar(solved(s)); }, std::array<double, 2>{0, 1},
               {.tolerance = 1e-13, .most_pieces = 256}) {}

  const ArcLengths& lengths() const { return lengths_; }
  Vec3 velocity(double t) const { return bezier_at(derivative_, t); }

  double parameter(double s) const {
    // Where the curve nearly stops, no polynomial follows its parameter: then it is solved for.
    return table_.kept() ? std::clamp(table_.at(s)[0], 0.0, 1.0) : solved(s);
  }

  std::size_t byte_size() const { return sizeof(*this) + table_.byte_size() + 1024; }

 private:
  using Scalar = Eigen::Matrix<double, 1, 1>;

  double solved(double s) const { return lengths_.parameter(s * lengths_.whole()); }

  std::vector<Vec3> derivative_;
  ArcLengths lengths_;
  PiecewiseQuintic<1> table_;
};

namespace {

/// Speeds below this part of the length have no direction worth reading.
constexpr double standstill = 1e-9;

/// Direction at a place where the derivative is nothing: by what lies a little before and behind.
Vec3 direction_beside(const std::vector<Vec3>& control, double t) {
  for (double step = 1e-6; step < 1; step *= 10) {
    const Vec3 direction =
        unit_or_zero(bezier_at(control, std::min(1.0, t + step)) - bezier_at(control, std::max(0.0, t - step)));
    if (!direction.isZero()) return direction;
  }
  return unit_or_zero(control.back() - control.front());
}

/// The limit of the tangent's direction at the start: towards the first control point that isn't the start.
Vec3 start_direction(const std::vector<Vec3>& control, double length) {
  for (const Vec3& point : control) {
    if ((point - control.front()).norm() > standstill * length) return (point - control.front()).normalized();
  }
  return direction_beside(control, 0);
}

}  // namespace

ArcLengthCurve::ArcLengthCurve(std::vector<Vec3> control) : control_(std::move(control)) {
  table_ = std::make_shared<const CurveParameterTable>(control_);
  length_ = table_->lengths().whole();
  start_derivative_ = length_ * start_direction(control_, length_);
  end_derivative_ = -length_ * start_direction({control_.rbegin(), control_.rend()}, length_);
}

double ArcLengthCurve::parameter(double s) const { return table_->parameter(s); }

Vec3 ArcLengthCurve::at(double s) const {
  if (s <= 0) return control_.front();
  if (s >= 1) return control_.back();
  return bezier_at(control_, table_->parameter(s));
}

ArcLengthCurve::Place ArcLengthCurve::place(double s) const {
  if (s <= 0) return {control_.front(), start_derivative_};
  if (s >= 1) return {control_.back(), end_derivative_};
  const double t = table_->parameter(s);
  const Vec3 velocity = table_->velocity(t);
  const double speed = velocity.norm();
  const Vec3 derivative =
      speed > standstill * length_ ? Vec3(velocity * (length_ / speed)) : Vec3(length_ * direction_beside(control_, t));
  return {bezier_at(control_, t), derivative};
}

double ArcLengthCurve::fraction(double t) const { return table_->lengths().to(t) / length_; }

std::size_t ArcLengthCurve::byte_size() const {
  return sizeof(*this) + 2 * control_.capacity() * sizeof(Vec3) + table_->byte_size();
}

double bezier_length(const std::vector<Vec3>& control) { return ArcLengths(control).whole(); }

}  // namespace croquis
