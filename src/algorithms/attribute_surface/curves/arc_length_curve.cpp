// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/arc_length_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "arc_lengths.h"
#include "bezier.h"

namespace croquis {

/// The curve's parameter as a function of the arc-length fraction: quintics on even pieces that have the exact value,
/// slope and bend at their ends.
class CurveParameterTable {
 public:
  explicit CurveParameterTable(const std::vector<Vec3>& control)
      : derivative_(bezier_derivative(control)), lengths_(control) {
    for (std::size_t count = 8; count <= most_pieces && !kept_; count *= 2) kept_ = fit(count);
  }

  const ArcLengths& lengths() const { return lengths_; }
  Vec3 velocity(double t) const { return bezier_at(derivative_, t); }

  double parameter(double s) const {
    // Where the curve nearly stops, no polynomial follows its parameter: then it is solved for.
    return kept_ ? std::clamp(tabled(s), 0.0, 1.0) : lengths_.parameter(s * lengths_.whole());
  }

  std::size_t byte_size() const { return sizeof(*this) + pieces_.capacity() * sizeof(Piece) + 1024; }

 private:
  using Piece = std::array<double, 6>;  ///< coefficients of 1, x … x^5, x = 0..1 along the piece

  static constexpr double tolerance = 1e-13;  ///< of the length
  static constexpr std::size_t most_pieces = 256;

  struct Jet {
    double value = 0;
    double slope = 0;
    double bend = 0;
  };

  /// By x of a piece that is one of that many.
  Jet jet(double t, double count) const {
    const double step = lengths_.whole() / count;
    const double speed = lengths_.speed(t);
    const double slope = step / speed;
    return {t, slope, -slope * slope * lengths_.speed_change(t) / speed};
  }

  static Piece between(const Jet& a, const Jet& b) {
    const double rise = b.value - a.value - a.slope - 0.5 * a.bend;
    const double turn = b.slope - a.slope - a.bend;
    const double bend = 0.5 * (b.bend - a.bend);
    return {a.value,
            a.slope,
            0.5 * a.bend,
            10 * rise - 4 * turn + bend,
            -15 * rise + 7 * turn - 2 * bend,
            6 * rise - 3 * turn + bend};
  }

  static double value_in(const Piece& c, double x) {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
  }

  double tabled(double s) const {
    const double along = s * static_cast<double>(pieces_.size());
    const std::size_t piece = std::min(static_cast<std::size_t>(along), pieces_.size() - 1);
    return value_in(pieces_[piece], along - static_cast<double>(piece));
  }

  /// @return whether the middles of all pieces are where they should be
  bool fit(std::size_t count) {
    const double whole = lengths_.whole();
    pieces_.clear();
    const auto parts = static_cast<double>(count);
    Jet before = jet(0, parts);
    for (std::size_t i = 1; i <= count; ++i) {
      const double end = static_cast<double>(i) / parts;
      const double guess = before.value + before.slope + 0.5 * before.bend;
      const Jet after = jet(i == count ? 1 : lengths_.parameter(end * whole, guess), parts);
      pieces_.push_back(between(before, after));
      const double middle = value_in(pieces_.back(), 0.5);
      const double miss = std::abs(lengths_.to(std::clamp(middle, 0.0, 1.0)) - (end - 0.5 / parts) * whole);
      if (!(miss <= tolerance * whole)) return false;
      before = after;
    }
    return true;
  }

  std::vector<Vec3> derivative_;
  ArcLengths lengths_;
  std::vector<Piece> pieces_;
  bool kept_ = false;
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
