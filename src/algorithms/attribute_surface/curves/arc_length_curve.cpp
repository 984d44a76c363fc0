// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/arc_length_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "algorithms/attribute_surface/curves/arc_lengths.h"
#include "algorithms/attribute_surface/curves/bezier.h"
#include "algorithms/attribute_surface/curves/piecewise_quintic.h"

namespace croquis {

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

/// The curve by its arc-length fraction: quintics on even pieces, with the exact place and derivatives at their ends.
class ArcLengthTable {
 public:
  explicit ArcLengthTable(const std::vector<Vec3>& control)
      : origin_(control.front()),
        control_(from_origin(control)),
        derivative_(bezier_derivative(control_)),
        second_derivative_(bezier_derivative(derivative_)),
        lengths_(control_) {
    for (std::size_t count = 4; count <= most_pieces && !kept_; count *= 2) kept_ = fit(count);
    if (!kept_) pieces_.clear();
  }

  double whole() const { return lengths_.whole(); }
  double fraction(double t) const { return lengths_.to(t) / whole(); }
  double parameter(double s) const { return lengths_.parameter(s * whole()); }

  Vec3 at(double s) const {
    // Where the curve nearly stops no polynomial follows it: then its parameter is solved for.
    if (!kept_) return origin_ + bezier_at(control_, parameter(s));
    const double along = s * static_cast<double>(pieces_.size());
    const std::size_t piece = std::min(static_cast<std::size_t>(along), pieces_.size() - 1);
    return origin_ + value_in(pieces_[piece], along - static_cast<double>(piece));
  }

  ArcLengthCurve::Place place(double s) const {
    if (!kept_) return solved_place(parameter(s));
    const auto count = static_cast<double>(pieces_.size());
    const double along = s * count;
    const std::size_t piece = std::min(static_cast<std::size_t>(along), pieces_.size() - 1);
    const double x = along - static_cast<double>(piece);
    return {origin_ + value_in(pieces_[piece], x), count * slope_in(pieces_[piece], x)};
  }

  std::size_t byte_size() const {
    return sizeof(*this) + pieces_.capacity() * sizeof(QuinticPiece) + 3 * control_.capacity() * sizeof(Vec3) + 1024;
  }

 private:
  static constexpr double tolerance = 2e-13;  ///< of the length; rounding alone comes near to half of it
  static constexpr std::size_t most_pieces = 1024;

  /// Far from the origin of the model the digits are kept for the curve.
  static std::vector<Vec3> from_origin(std::vector<Vec3> control) {
    const Vec3 origin = control.front();
    for (Vec3& point : control) point -= origin;
    return control;
  }

  ArcLengthCurve::Place solved_place(double t) const {
    const Vec3 velocity = bezier_at(derivative_, t);
    const double speed = velocity.norm();
    const bool moves = speed > standstill * whole();
    return {origin_ + bezier_at(control_, t),
            moves ? Vec3(velocity * (whole() / speed)) : Vec3(whole() * direction_beside(control_, t))};
  }

  /// By x of a piece that is so long.
  QuinticEnd end_at(double t, double length) const {
    const Vec3 velocity = bezier_at(derivative_, t);
    const double speed = velocity.norm();
    const Vec3 along = velocity / speed;
    QuinticEnd end{bezier_at(control_, t), length * along, Vec3::Zero()};
    if (second_derivative_.empty()) return end;
    const Vec3 change = bezier_at(second_derivative_, t);
    end.bend = (length / speed) * (length / speed) * (change - change.dot(along) * along);
    return end;
  }

  /// The parameter so much farther along the curve, solved from what is known at t.
  double stepped(double t, double target, double step) const {
    const double speed = lengths_.speed(t);
    const Vec3 velocity = bezier_at(derivative_, t);
    const double change = second_derivative_.empty() ? 0 : velocity.dot(bezier_at(second_derivative_, t)) / speed;
    const double guess = step / speed;
    return lengths_.parameter(target, t + guess - 0.5 * guess * guess * change / speed);
  }

  /// @return whether the middles of all pieces are where they should be
  bool fit(std::size_t count) {
    const double length = whole() / static_cast<double>(count);
    pieces_.clear();
    double t = 0;
    QuinticEnd before = end_at(0, length);
    for (std::size_t i = 0; i < count; ++i) {
      const double start = static_cast<double>(i) * length;
      const double middle = stepped(t, start + 0.5 * length, 0.5 * length);
      t = i + 1 == count ? 1 : stepped(middle, start + length, 0.5 * length);
      const QuinticEnd after = end_at(t, length);
      pieces_.push_back(quintic_between(before, after));
      const double miss = (value_in(pieces_.back(), 0.5) - bezier_at(control_, middle)).norm();
      if (!(miss <= tolerance * whole())) return false;
      before = after;
    }
    return true;
  }

  Vec3 origin_;                ///< the start of the curve
  std::vector<Vec3> control_;  ///< from there
  std::vector<Vec3> derivative_;
  std::vector<Vec3> second_derivative_;
  ArcLengths lengths_;
  std::vector<QuinticPiece> pieces_;
  bool kept_ = false;
};

ArcLengthCurve::ArcLengthCurve(std::vector<Vec3> control) : control_(std::move(control)) {
  table_ = std::make_shared<const ArcLengthTable>(control_);
  length_ = table_->whole();
  start_derivative_ = length_ * start_direction(control_, length_);
  end_derivative_ = -length_ * start_direction({control_.rbegin(), control_.rend()}, length_);
}

double ArcLengthCurve::parameter(double s) const { return table_->parameter(s); }

Vec3 ArcLengthCurve::at(double s) const {
  if (s <= 0) return control_.front();
  if (s >= 1) return control_.back();
  return table_->at(s);
}

ArcLengthCurve::Place ArcLengthCurve::place(double s) const {
  if (s <= 0) return {control_.front(), start_derivative_};
  if (s >= 1) return {control_.back(), end_derivative_};
  return table_->place(s);
}

double ArcLengthCurve::fraction(double t) const { return table_->fraction(t); }

std::size_t ArcLengthCurve::byte_size() const {
  return sizeof(*this) + control_.capacity() * sizeof(Vec3) + table_->byte_size();
}

double bezier_length(const std::vector<Vec3>& control) { return ArcLengths(control).whole(); }

}  // namespace croquis
