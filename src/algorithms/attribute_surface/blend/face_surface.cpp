// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/face_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/blend/surface_base.h"

namespace croquis {

/// Points and inner curves of a face, as displacements of the surface of its sides.
/// Source: Kim and Park 2006, equations (2.4), (2.5). There a point's weight meets the point itself, and the surface
/// shrinks to a needle; the displacement that is blended here leaves a surface alone that meets the point already.
class SurfaceAttributes {
 public:
  /// Points' radii that are missing are filled in.
  SurfaceAttributes(const SurfaceBase& base, std::vector<PlacedPoint> points, std::vector<PlacedCurve> curves);

  const std::vector<PlacedPoint>& points() const { return points_; }
  const std::vector<PlacedCurve>& curves() const { return curves_; }

  /// The surface with them, from what the sides give there.
  template <class Numbers>
  typename Numbers::Vector blend(const SurfaceBase& base, const BaseBlend<Numbers>& sides, const Vec2& place) const;

  std::size_t byte_size() const;

 private:
  /// A point with what doesn't depend on the place that is evaluated.
  struct Displacement {
    Vec2 place;
    Vec3 offset;             ///< of the surface of the sides: it is moved this far there
    Vec3 du = Vec3::Zero();  ///< change of that offset by the domain's coordinates, for a normal
    Vec3 dv = Vec3::Zero();
    double reach = 0;     ///< rho, in the domain
    double strength = 0;  ///< weight of the sides there × reach^2, or × reach for cones
    bool cone = false;
  };

  /// A piece of an inner curve's footprint.
  struct Segment {
    Vec2 from;
    Vec2 along;   ///< unit
    Vec2 across;  ///< unit
    double length = 0;
    Vec3 offset;         ///< at its start
    Vec3 offset_change;  ///< to its end
    double strength = 0;
    bool sharp = false;
  };

  template <class Numbers>
  struct Sums;

  void prepare(const SurfaceBase& base, PlacedPoint& point);
  void prepare(const SurfaceBase& base, const PlacedCurve& curve);
  const Displacement* point_under(const Vec2& place) const;
  double scale_near_points(const Vec2& place) const;

  template <class Numbers>
  static typename Numbers::Vector offset_of(const Displacement& point, const typename Numbers::Number& x,
                                            const typename Numbers::Number& y);
  template <class Numbers>
  void add_points(Sums<Numbers>& sums, const Vec2& place) const;
  template <class Numbers>
  void add_segments(Sums<Numbers>& sums, const Vec2& place) const;
  template <class Numbers>
  typename Numbers::Vector blend_as_in_paper(const BaseBlend<Numbers>& sides, const Vec2& place) const;

  std::vector<PlacedPoint> points_;
  std::vector<PlacedCurve> curves_;
  std::vector<Displacement> displacements_;
  std::vector<Segment> segments_;
};

namespace {

/// A place this near to a point's, in domains of perimeter 1, is that place.
constexpr double on_a_point = 1e-14;
/// Points act as far as this many of their reaches.
constexpr double farthest_reach = 3;
/// Square of the least distance from an inner curve's footprint that counts as one.
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

std::size_t SurfaceAttributes::byte_size() const {
  std::size_t bytes = sizeof(*this) + points_.capacity() * sizeof(PlacedPoint) +
                      displacements_.capacity() * sizeof(Displacement) + segments_.capacity() * sizeof(Segment);
  for (const PlacedCurve& curve : curves_) bytes += curve.places.capacity() * (sizeof(Vec2) + sizeof(Vec3));
  return bytes;
}

namespace {

/// Corners have no derivatives of their own: they are read this far inside, in domains of perimeter 1.
constexpr double beside_a_corner = 1e-7;

SurfacePlace place_of(const DualVector& blended) { return {blended.value, blended.du, blended.dv}; }

/// Off corners and footprints of cones, where the surface has no derivative.
Vec2 where_smooth(const SurfaceBase& base, const Vec2& place) {
  for (const Vec2& corner : base.polygon().corners) {
    if ((place - corner).norm() < beside_a_corner) {
      return place + beside_a_corner * (base.polygon().middle - corner).normalized();
    }
  }
  return place;
}

}  // namespace

FaceSurface::FaceSurface(const SurfaceFrame& frame) : base_(std::make_shared<const SurfaceBase>(frame)) {}

FaceSurface::FaceSurface(std::shared_ptr<const SurfaceBase> base, std::shared_ptr<const SurfaceAttributes> attributes)
    : base_(std::move(base)), attributes_(std::move(attributes)) {}

FaceSurface FaceSurface::with(std::vector<PlacedPoint> points, std::vector<PlacedCurve> curves) const {
  if (points.empty() && curves.empty()) return {base_, nullptr};
  return {base_, std::make_shared<const SurfaceAttributes>(*base_, std::move(points), std::move(curves))};
}

const DomainPolygon& FaceSurface::domain() const { return base_->polygon(); }
const SurfaceFrame& FaceSurface::frame() const { return base_->frame(); }
double FaceSurface::sigma() const { return base_->sigma(); }

const std::vector<PlacedPoint>& FaceSurface::points() const {
  static const std::vector<PlacedPoint> none;
  return attributes_ ? attributes_->points() : none;
}

const std::vector<PlacedCurve>& FaceSurface::curves() const {
  static const std::vector<PlacedCurve> none;
  return attributes_ ? attributes_->curves() : none;
}

Vec3 FaceSurface::at(const Vec2& place) const {
  const std::size_t under = base_->footprint_under(place);
  if (under < base_->footprints().size()) return base_->on_footprint(under, place);
  const auto sides = base_->blend<PlainNumbers>(place);
  return attributes_ ? attributes_->blend(*base_, sides, place) : sides.point;
}

Vec3 FaceSurface::base_at(const Vec2& place) const {
  const std::size_t under = base_->footprint_under(place);
  if (under < base_->footprints().size()) return base_->on_footprint(under, place);
  return base_->blend<PlainNumbers>(place).point;
}

SurfacePlace FaceSurface::evaluate(const Vec2& place) const {
  const Vec2 smooth = where_smooth(*base_, place);
  const auto sides = base_->blend<DualNumbers>(smooth);
  SurfacePlace result = place_of(attributes_ ? attributes_->blend(*base_, sides, smooth) : sides.point);
  if (base_->footprint_under(place) < base_->footprints().size()) result.point = at(place);
  return result;
}

SurfacePlace FaceSurface::evaluate_base(const Vec2& place) const {
  SurfacePlace result = place_of(base_->blend<DualNumbers>(where_smooth(*base_, place)).point);
  if (base_->footprint_under(place) < base_->footprints().size()) result.point = base_at(place);
  return result;
}

Vec3 FaceSurface::normal(const Vec2& place) const {
  const std::size_t under = base_->footprint_under(place);
  const auto& footprints = base_->footprints();
  if (under < footprints.size() && footprints[under].has_fence() && frame().mode == AttributeMode::Smooth) {
    const Footprint& side = footprints[under];
    const double t = std::clamp((place - side.from).dot(side.along) / side.length, 0.0, 1.0);
    const std::size_t per_side = footprints.size() / frame().sides.size();
    return side_normal(under / per_side, (static_cast<double>(under % per_side) + t) / static_cast<double>(per_side));
  }
  const SurfacePlace surface = evaluate(place);
  return unit_or_zero(surface.du.cross(surface.dv));
}

Vec3 FaceSurface::side_normal(std::size_t side, double fraction) const {
  const SurfaceSide& along = frame().sides[side];
  if (along.fence.empty()) return normal(side_place(side, fraction));
  Vec3 tangent = along.curve->place(along.reversed ? 1 - fraction : fraction).derivative.normalized();
  if (along.reversed) tangent = -tangent;
  return base_->fences()[side].normal(fraction, tangent);
}

Vec2 FaceSurface::side_place(std::size_t side, double fraction) const {
  const std::size_t per_side = base_->footprints().size() / frame().sides.size();
  const double along = fraction * static_cast<double>(per_side);
  const auto part = std::min(static_cast<std::size_t>(along), per_side - 1);
  const std::size_t index = side * per_side + part;
  const Vec2& from = domain().corners[index];
  const Vec2& to = domain().corners[(index + 1) % domain().corners.size()];
  const double t = along - static_cast<double>(part);
  return t >= 1 ? to : Vec2(from + t * (to - from));
}

std::size_t FaceSurface::byte_size() const {
  return sizeof(*this) + base_->byte_size() + (attributes_ ? attributes_->byte_size() : 0);
}

}  // namespace croquis
