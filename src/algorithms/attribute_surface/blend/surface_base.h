// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "algorithms/attribute_surface/curves/piecewise_quintic.h"
#include "croquis/attribute_surface/face_surface.h"
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

/// A fence, read between its keys.
class FenceReader {
 public:
  explicit FenceReader(const NormalFence& fence);

  /// The normal at a fraction of the side, projected off the curve's tangent there.
  /// @param tangent unit
  Vec3 normal(double at, const Vec3& tangent) const;

 private:
  Vec3 between_keys(double at) const;

  NormalFence fence_;
  std::vector<double> angles_;  ///< between a key and the next, radians
};

/// One straight side of a domain and what lies along it: a curve, or half of one in a domain of two curves. Everything
/// along it is read by the fraction t = 0..1 in the loop's direction.
class Footprint {
 public:
  struct Extent {
    double begin = 0;  ///< fraction of the side's curve in the loop's direction
    double end = 1;
  };

  /// @param sigma model units per unit of the domain, for the conormals' length
  Footprint(const DomainPolygon& polygon, std::size_t index, const SurfaceSide& side, const Extent& extent);

  Vec2 from;
  Vec2 along;    ///< unit
  Vec2 inwards;  ///< unit
  double length = 0;

  Vec3 point(double t) const { return curve_->at(fraction(t)); }

  /// The derivative is by t.
  ArcLengthCurve::Place place(double t) const;

  const Vec3& start() const { return start_.point; }
  const Vec3& end() const { return end_.point; }
  const Vec3& start_derivative() const { return start_.derivative; }
  const Vec3& end_derivative() const { return end_.derivative; }

  bool has_fence() const { return conormals_ != nullptr; }

  /// Of the surface, into the face, as long as the fence's magnitude: the surface's derivative across the side in
  /// arc-length units.
  Vec3 conormal(double t) const { return conormals_->at(t); }
  PiecewiseQuintic::ValueAndSlope conormal_place(double t) const { return conormals_->evaluate(t); }

  std::size_t byte_size() const { return sizeof(*this) + (conormals_ ? conormals_->byte_size() : 0); }

 private:
  double fraction(double t) const { return first_ + t * step_; }

  std::shared_ptr<const ArcLengthCurve> curve_;
  double first_ = 0;  ///< the curve's own fraction where the footprint begins
  double step_ = 1;   ///< to its end: below 0 where the curve is walked along backwards
  ArcLengthCurve::Place start_;
  ArcLengthCurve::Place end_;
  std::shared_ptr<const PiecewiseQuintic> conormals_;  ///< null: no fence
};

/// Distances below this, of domains of perimeter 1, are none.
inline constexpr double on_a_side = 1e-14;

/// What the sides of a face give at a place of its domain.
template <class Numbers>
struct BaseBlend {
  using Number = typename Numbers::Number;

  typename Numbers::Vector point;
  Number nearness = 0.0;     ///< the least distance to a side
  Number side_weight = 0.0;  ///< W_b nearness^2: weight of all sides together against points and inner curves
};

/// The surface of the curves of a loop alone.
/// Source: Kim and Park 2006, equations (1.2), (2.1), (2.2), (2.3), in the form of the project's documentation: feet on
/// the lines of the sides, weights length / distance, ribbons.
class SurfaceBase {
 public:
  explicit SurfaceBase(const SurfaceFrame& frame);

  const SurfaceFrame& frame() const { return frame_; }
  const DomainPolygon& polygon() const { return polygon_; }
  const std::vector<Footprint>& footprints() const { return footprints_; }

  /// Of the sides of the loop, which have them in mode Smooth.
  const std::vector<FenceReader>& fences() const { return fences_; }
  double sigma() const { return sigma_; }
  bool is_paper() const { return frame_.mode == AttributeMode::Paper; }

  /// The footprint that a place lies on, or their number; the corner's first one in a corner.
  std::size_t footprint_under(const Vec2& place) const;

  /// The place of the curve under a footprint.
  Vec3 on_footprint(std::size_t footprint, const Vec2& place) const;

  /// @pre in the domain; not in a corner. On a side the limit from inside
  template <class Numbers>
  BaseBlend<Numbers> blend(const Vec2& place) const;

  /// Weight of all sides together: sum (L_i / h_i)^2.
  double boundary_weight(const Vec2& place) const;

  /// Least distance to the sides' lines.
  double depth(const Vec2& place) const;

  std::size_t byte_size() const;

 private:
  template <class Numbers>
  BaseBlend<Numbers> blend_by_lines(const Vec2& place) const;
  template <class Numbers>
  BaseBlend<Numbers> blend_as_in_paper(const Vec2& place) const;

  SurfaceFrame frame_;
  DomainPolygon polygon_;
  std::vector<Footprint> footprints_;
  std::vector<FenceReader> fences_;
  double sigma_ = 0;
  double middle_bubble_ = 1;  ///< 1 / boundary weight at the area's centroid
};

}  // namespace croquis
