// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "croquis/geometry/vector.h"

/// Numbers and vectors with their derivatives by the two coordinates of a domain (forward automatic differentiation).
/// Blending is written once for plain numbers and for these.
namespace croquis {

struct Dual {
  double value = 0;
  Vec2 slope = Vec2::Zero();

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor): constants are numbers, too
  Dual(double number, const Vec2& derivative) : value(number), slope(derivative) {}

  Dual& operator+=(const Dual& b) {
    value += b.value;
    slope += b.slope;
    return *this;
  }
};

inline Dual operator+(Dual a, const Dual& b) { return a += b; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
inline Dual square_root(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, a.slope / (2 * root)};
}
inline double square_root(double a) { return std::sqrt(a); }

inline Dual logarithm(const Dual& a) { return {std::log(a.value), a.slope / a.value}; }
inline double logarithm(double a) { return std::log(a); }

inline Dual arc_tangent(const Dual& y, const Dual& x) {
  const double square = x.value * x.value + y.value * y.value;
  return {std::atan2(y.value, x.value), (x.value * y.slope - y.value * x.slope) / square};
}
inline double arc_tangent(double y, double x) { return std::atan2(y, x); }

inline double value_of(double number) { return number; }
inline double value_of(const Dual& number) { return number.value; }

/// The same, but not below a bound; there it stands still.
inline double at_least(double number, double bound) { return std::max(number, bound); }
inline Dual at_least(const Dual& number, double bound) { return number.value < bound ? Dual(bound) : number; }
inline double at_most(double number, double bound) { return std::min(number, bound); }
inline Dual at_most(const Dual& number, double bound) { return number.value > bound ? Dual(bound) : number; }

struct DualVector {
  Vec3 value = Vec3::Zero();
  Vec3 du = Vec3::Zero();
  Vec3 dv = Vec3::Zero();

  DualVector() = default;
  DualVector(const Vec3& constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
  DualVector(const Vec3& vector, const Vec3& by_u, const Vec3& by_v) : value(vector), du(by_u), dv(by_v) {}

  DualVector& operator+=(const DualVector& b) {
    value += b.value;
    du += b.du;
    dv += b.dv;
    return *this;
  }
};

inline DualVector operator+(DualVector a, const DualVector& b) { return a += b; }
inline DualVector operator-(const DualVector& a, const DualVector& b) {
  return {a.value - b.value, a.du - b.du, a.dv - b.dv};
}
inline DualVector operator*(const Dual& a, const DualVector& b) {
  return {a.value * b.value, a.value * b.du + a.slope.x() * b.value, a.value * b.dv + a.slope.y() * b.value};
}
inline DualVector operator/(const DualVector& a, const Dual& b) {
  const double inverse = 1 / b.value;
  const Vec3 quotient = a.value * inverse;
  return {quotient, (a.du - b.slope.x() * quotient) * inverse, (a.dv - b.slope.y() * quotient) * inverse};
}

/// The kinds of numbers that blending is written for.
struct PlainNumbers {
  using Number = double;
  using Vector = Vec3;
};
struct DualNumbers {
  using Number = Dual;
  using Vector = DualVector;
};

/// The distance of a place to a line along a direction: a coordinate in a turned frame.
inline double coordinate(const Vec2& place, const Vec2& from, const Vec2& direction, double) {
  return (place - from).dot(direction);
}
inline Dual coordinate(const Vec2& place, const Vec2& from, const Vec2& direction, const Dual&) {
  return {(place - from).dot(direction), direction};
}

/// The value of a function of one number whose slope is known.
inline const Vec3& chained(const Vec3& value, const Vec3&, double) { return value; }
inline DualVector chained(const Vec3& value, const Vec3& slope, const Dual& at) {
  return {value, at.slope.x() * slope, at.slope.y() * slope};
}

}  // namespace croquis
