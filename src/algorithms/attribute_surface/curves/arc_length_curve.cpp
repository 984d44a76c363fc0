// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/arc_length_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/attribute_surface/curves/piecewise_quintic.h"
#include "croquis/geometry/vector.h"

namespace croquis {
namespace {

/// A place of a Bézier curve of any degree, without allocating (nested multiplication of the Bernstein form).
/// @pre control is not empty; t in 0..1
Vec3 bezier_of_any_degree(std::span<const Vec3> control, double t) {
  const std::size_t degree = control.size() - 1;
  if (degree == 0) return control[0];
  double power = 1;
  double binomial = 1;
  Vec3 sum = control[0] * (1 - t);
  for (std::size_t i = 1; i < degree; ++i) {
    power *= t;
    binomial *= static_cast<double>(degree - i + 1) / static_cast<double>(i);
    sum = (sum + power * binomial * control[i]) * (1 - t);
  }
  return sum + power * t * control[degree];
}

/// The same; up to cubics, which most curves are, written out.
Vec3 bezier_at(std::span<const Vec3> control, double t) {
  const double u = 1 - t;
  switch (control.size()) {
    case 2: return u * control[0] + t * control[1];
    case 3: return (u * u) * control[0] + (2 * u * t) * control[1] + (t * t) * control[2];
    case 4:
      return (u * u * u) * control[0] + (3 * u * u * t) * control[1] + (3 * u * t * t) * control[2] +
             (t * t * t) * control[3];
    default: return bezier_of_any_degree(control, t);
  }
}

/// Control points of the derivative: one less.
std::vector<Vec3> bezier_derivative(std::span<const Vec3> control) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i + 1 < control.size(); ++i) {
    result.push_back(static_cast<double>(control.size() - 1) * (control[i + 1] - control[i]));
  }
  return result;
}

/// The arc length of a Bézier curve as a function of its parameter, by Gauss quadrature on parts that are halved until
/// it is exact to rounding.
class ArcLengths {
 public:
  explicit ArcLengths(const std::vector<Vec3>& control);

  double whole() const { return sums_.back(); }

  /// From the start to t in 0..1.
  double to(double t) const;

  /// The parameter of an arc length 0..whole().
  double parameter(double length) const;

  /// The same, found sooner from a guess that is nearly right.
  double parameter(double length, double guess) const;

  /// |C'(t)|.
  double speed(double t) const;

 private:
  double quadrature(double from, double to) const;
  void add_parts(double from, double to, double length, int depth);

  std::vector<Vec3> derivative_;
  double scale_ = 0;          ///< length of the control polygon
  std::vector<double> ends_;  ///< of the parts, the first 0, the last 1
  std::vector<double> sums_;  ///< arc length up to each of them
};

// Gauss-Legendre quadrature of 8 points on -1..1, half of them (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 4> gauss_places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};

/// Parts are halved until halving changes them by less than this part of the curve.
constexpr double quadrature_tolerance = 1e-14;
constexpr int deepest_halving = 24;
ArcLengths::ArcLengths(const std::vector<Vec3>& control) : derivative_(bezier_derivative(control)) {
  for (std::size_t i = 0; i + 1 < control.size(); ++i) scale_ += (control[i + 1] - control[i]).norm();
  ends_.push_back(0);
  sums_.push_back(0);
  add_parts(0, 0.5, quadrature(0, 0.5), 1);
  add_parts(0.5, 1, quadrature(0.5, 1), 1);
}

double ArcLengths::speed(double t) const { return bezier_at(derivative_, t).norm(); }

double ArcLengths::quadrature(double from, double to) const {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < gauss_places.size(); ++i) {
    sum += gauss_weights[i] * (speed(middle - half * gauss_places[i]) + speed(middle + half * gauss_places[i]));
  }
  return half * sum;
}

void ArcLengths::add_parts(double from, double to, double length, int depth) {
  const double middle = 0.5 * (from + to);
  const double first = quadrature(from, middle);
  const double second = quadrature(middle, to);
  if (depth < deepest_halving && std::abs(first + second - length) > quadrature_tolerance * scale_) {
    add_parts(from, middle, first, depth + 1);
    add_parts(middle, to, second, depth + 1);
    return;
  }
  ends_.push_back(middle);
  sums_.push_back(sums_.back() + first);
  ends_.push_back(to);
  sums_.push_back(sums_.back() + second);
}

double ArcLengths::to(double t) const {
  const auto next = std::ranges::upper_bound(ends_, t);
  const auto part = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next - ends_.begin()) - 1);
  if (part + 1 >= ends_.size()) return whole();
  return t <= ends_[part] ? sums_[part] : sums_[part] + quadrature(ends_[part], t);
}

double ArcLengths::parameter(double length) const {
  const auto next = std::ranges::upper_bound(sums_, length);
  if (next == sums_.begin()) return 0;
  if (next == sums_.end()) return 1;
  const auto part = static_cast<std::size_t>(next - sums_.begin()) - 1;
  const double share = (length - sums_[part]) / (sums_[part + 1] - sums_[part]);
  return parameter(length, ends_[part] + (ends_[part + 1] - ends_[part]) * share);
}

double ArcLengths::parameter(double length, double guess) const {
  const auto next = std::ranges::upper_bound(sums_, length);
  if (next == sums_.begin()) return 0;
  if (next == sums_.end()) return 1;
  const auto part = static_cast<std::size_t>(next - sums_.begin()) - 1;
  double low = ends_[part];
  double high = ends_[part + 1];
  double t = std::clamp(guess, low, high);
  // Newton's steps, and halves of the bracket where the curve hardly moves.
  for (int i = 0; i < 60; ++i) {
    const double excess = sums_[part] + quadrature(ends_[part], t) - length;
    if (std::abs(excess) <= 4e-16 * scale_) break;
    (excess > 0 ? high : low) = t;
    const double v = speed(t);
    double better = v > 0 ? t - excess / v : high;
    const bool inside = better > low - 1e-12 && better < high + 1e-12;  // of a part whose end is sought, about there
    better = inside ? std::clamp(better, low, high) : 0.5 * (low + high);
    const double step = std::abs(better - t);
    t = better;
    if (step <= 1e-9) break;  // the next one would be about its square
  }
  return t;
}

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
