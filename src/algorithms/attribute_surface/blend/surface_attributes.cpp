// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/blend/surface_attributes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis {
namespace {

/// A place this near to a point's, in domains of perimeter 1, is that place.
constexpr double on_a_point = 1e-14;
/// Points act as far as this many of their reaches.
constexpr double farthest_reach = 3;
/// Square of the least distance from an inner curve's footprint that is told from none.
constexpr double least_square = 1e-26;

/// The radius as a distance in the domain: half of the distance to the sides where none is given.
double reach_of(const SurfaceBase& base, const Vec2& place, const std::optional<double>& radius) {
  return radius ? *radius / base.sigma() : 0.5 * base.depth(place);
}

/// Weight that falls to 0 at the farthest reach, without a kink.
template <class Number>
Number falloff(const Number& square_of_distance, double reach) {
  const double square = farthest_reach * reach * farthest_reach * reach;
  const Number inside = at_least(1.0 - square_of_distance / square, 0.0);
  return inside * inside;
}

/// Integrals along a segment of 1 / distance^3 and s / distance^3 (smooth) or of 1 / distance^2 and s / distance^2
/// (sharp), in closed form.
template <class Number>
struct LineIntegrals {
  Number zeroth;
  Number first;
};

template <class Number>
LineIntegrals<Number> smooth_integrals(const Number& s, const Number& square, double length) {
  const Number rest = length - s;
  const Number from_end = square_root(rest * rest + square);
  const Number from_start = square_root(s * s + square);
  const Number zeroth = (rest / from_end + s / from_start) / square;
  return {zeroth, (1.0 / from_start - 1.0 / from_end) + s * zeroth};
}

template <class Number>
LineIntegrals<Number> sharp_integrals(const Number& s, const Number& square, double length) {
  const Number rest = length - s;
  const Number distance = square_root(square);
  const Number zeroth = (arc_tangent(rest, distance) + arc_tangent(s, distance)) / distance;
  const Number ends = (rest * rest + square) / (s * s + square);
  return {zeroth, s * zeroth + 0.5 * logarithm(ends)};
}

}  // namespace

template <class Numbers>
struct SurfaceAttributes::Sums {
  typename Numbers::Vector offsets = typename Numbers::Vector(Vec3(Vec3::Zero()));
  typename Numbers::Number weights = 0.0;
  /// All weights are taken times these: the square of the distance to the sides, and that to the nearest point, so
  /// that none grows beyond all bounds.
  typename Numbers::Number scale = 1.0;
};

SurfaceAttributes::SurfaceAttributes(const SurfaceBase& base, std::vector<PlacedPoint> points,
                                     std::vector<PlacedCurve> curves)
    : points_(std::move(points)), curves_(std::move(curves)) {
  for (PlacedPoint& point : points_) prepare(base, point);
  for (const PlacedCurve& curve : curves_) prepare(base, curve);
}

void SurfaceAttributes::prepare(const SurfaceBase& base, PlacedPoint& point) {
  Displacement displacement;
  displacement.place = point.place;
  displacement.offset = point.point - base.blend<PlainNumbers>(point.place).point;
  if (point.normal) {
    const DualVector sides = base.blend<DualNumbers>(point.place).point;
    displacement.du = -point.normal->dot(sides.du) * *point.normal;
    displacement.dv = -point.normal->dot(sides.dv) * *point.normal;
  }
  displacement.reach = reach_of(base, point.place, point.radius);
  point.radius = displacement.reach * base.sigma();
  displacement.cone = point.profile == PointProfile::Cone;
  displacement.strength =
      base.boundary_weight(point.place) * displacement.reach * (displacement.cone ? 1 : displacement.reach);
  displacements_.push_back(displacement);
}

void SurfaceAttributes::prepare(const SurfaceBase& base, const PlacedCurve& curve) {
  std::vector<Vec3> offsets;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    offsets.push_back(curve.points[i] - base.blend<PlainNumbers>(curve.places[i]).point);
  }
  for (std::size_t i = 0; i + 1 < curve.places.size(); ++i) {
    const Vec2 whole = curve.places[i + 1] - curve.places[i];
    if (whole.norm() < on_a_point) continue;
    Segment segment;
    segment.from = curve.places[i];
    segment.length = whole.norm();
    segment.along = whole / segment.length;
    segment.across = left_of(segment.along);
    segment.offset = offsets[i];
    segment.offset_change = offsets[i + 1] - offsets[i];
    const Vec2 middle = 0.5 * (curve.places[i] + curve.places[i + 1]);
    const double reach = reach_of(base, middle, curve.radius);
    segment.strength = base.boundary_weight(middle) * reach * reach / 2;
    segment.sharp = curve.profile == InnerProfile::Sharp;
    segments_.push_back(segment);
  }
}

const SurfaceAttributes::Displacement* SurfaceAttributes::point_under(const Vec2& place) const {
  for (const Displacement& point : displacements_) {
    if ((place - point.place).norm() < on_a_point) return &point;
  }
  return nullptr;
}

/// The least ratio of distance to reach among the points, squared; 1 beyond their reach.
double SurfaceAttributes::scale_near_points(const Vec2& place) const {
  double least = 1;
  for (const Displacement& point : displacements_) {
    least = std::min(least, (place - point.place).squaredNorm() / (point.reach * point.reach));
  }
  return least;
}

template <class Numbers>
typename Numbers::Vector SurfaceAttributes::offset_of(const Displacement& point, const typename Numbers::Number& x,
                                                      const typename Numbers::Number& y) {
  using Vector = typename Numbers::Vector;
  return Vector(point.offset) + x * Vector(point.du) + y * Vector(point.dv);
}

template <class Numbers>
void SurfaceAttributes::add_points(Sums<Numbers>& sums, const Vec2& place) const {
  using Number = typename Numbers::Number;
  for (const Displacement& point : displacements_) {
    if ((place - point.place).norm() >= farthest_reach * point.reach) continue;
    const Number x = coordinate(place, point.place, Vec2::UnitX(), Number());
    const Number y = coordinate(place, point.place, Vec2::UnitY(), Number());
    const Number square = x * x + y * y;
    const Number weight =
        sums.scale * (point.strength * falloff(square, point.reach)) / (point.cone ? square_root(square) : square);
    sums.offsets += weight * offset_of<Numbers>(point, x, y);
    sums.weights += weight;
  }
}

template <class Numbers>
void SurfaceAttributes::add_segments(Sums<Numbers>& sums, const Vec2& place) const {
  using Number = typename Numbers::Number;
  using Vector = typename Numbers::Vector;
  for (const Segment& segment : segments_) {
    const Number s = coordinate(place, segment.from, segment.along, Number());
    const Number across = coordinate(place, segment.from, segment.across, Number());
    const Number square = at_least(across * across, least_square);
    const LineIntegrals<Number> integrals =
        segment.sharp ? sharp_integrals(s, square, segment.length) : smooth_integrals(s, square, segment.length);
    const Number strength = sums.scale * segment.strength;
    sums.offsets += (strength * integrals.zeroth) * Vector(segment.offset);
    sums.offsets += (strength * integrals.first / segment.length) * Vector(segment.offset_change);
    sums.weights += strength * integrals.zeroth;
  }
}

template <class Numbers>
typename Numbers::Vector SurfaceAttributes::blend(const SurfaceBase& base, const BaseBlend<Numbers>& sides,
                                                  const Vec2& place) const {
  if (base.is_paper()) return blend_as_in_paper(sides, place);
  if (const Displacement* point = point_under(place)) {
    const auto x = coordinate(place, point->place, Vec2::UnitX(), typename Numbers::Number());
    const auto y = coordinate(place, point->place, Vec2::UnitY(), typename Numbers::Number());
    return sides.point + offset_of<Numbers>(*point, x, y);
  }
  Sums<Numbers> sums;
  const double near_points = scale_near_points(place);
  sums.scale = near_points * sides.nearness * sides.nearness;
  add_points(sums, place);
  add_segments(sums, place);
  return sides.point + sums.offsets / (sums.weights + near_points * sides.side_weight);
}

/// (2.4) and (2.5) taken literally, for comparison: the point itself with the weight 1 / distance.
template <class Numbers>
typename Numbers::Vector SurfaceAttributes::blend_as_in_paper(const BaseBlend<Numbers>& sides,
                                                              const Vec2& place) const {
  using Number = typename Numbers::Number;
  using Vector = typename Numbers::Vector;
  Vector sum = sides.side_weight * sides.point;
  Number weights = sides.side_weight;
  for (const PlacedPoint& point : points_) {
    if ((place - point.place).norm() < on_a_point) return Vector(point.point);
    const Number x = coordinate(place, point.place, Vec2::UnitX(), Number());
    const Number y = coordinate(place, point.place, Vec2::UnitY(), Number());
    const Number weight = sides.nearness / square_root(x * x + y * y);
    sum += weight * Vector(point.point);
    weights += weight;
  }
  return sum / weights;
}

template Vec3 SurfaceAttributes::blend<PlainNumbers>(const SurfaceBase&, const BaseBlend<PlainNumbers>&,
                                                     const Vec2&) const;
template DualVector SurfaceAttributes::blend<DualNumbers>(const SurfaceBase&, const BaseBlend<DualNumbers>&,
                                                          const Vec2&) const;

std::size_t SurfaceAttributes::byte_size() const {
  std::size_t bytes = sizeof(*this) + points_.capacity() * sizeof(PlacedPoint) +
                      displacements_.capacity() * sizeof(Displacement) + segments_.capacity() * sizeof(Segment);
  for (const PlacedCurve& curve : curves_) bytes += curve.places.capacity() * (sizeof(Vec2) + sizeof(Vec3));
  return bytes;
}

}  // namespace croquis
