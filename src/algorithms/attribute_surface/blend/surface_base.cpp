// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/blend/surface_base.h"

#include <limits>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Evenly turned from a to b, both unit, at that angle to each other.
Vec3 turned_between(const Vec3& a, const Vec3& b, double angle, double part) {
  if (std::sin(angle) < 1e-9) return (1 - part) * a + part * b;
  return (std::sin((1 - part) * angle) * a + std::sin(part * angle) * b) / std::sin(angle);
}

/// Where conormals may have kinks: keys of the fence inside the extent, as fractions of it.
std::vector<double> breaks_in(const NormalFence& fence, const Footprint::Extent& extent) {
  std::vector<double> breaks{0};
  for (const double at : fence.at) {
    const double t = (at - extent.begin) / (extent.end - extent.begin);
    if (t > breaks.back() + 1e-9 && t < 1 - 1e-9) breaks.push_back(t);
  }
  breaks.push_back(1);
  return breaks;
}

/// Lengths of the domain's sides: of two curves both halves each.
std::vector<double> footprint_lengths(const SurfaceFrame& frame) {
  std::vector<double> lengths;
  for (const SurfaceSide& side : frame.sides) {
    if (frame.sides.size() == 2) {
      lengths.insert(lengths.end(), 2, 0.5 * side.curve->length());
    } else {
      lengths.push_back(side.curve->length());
    }
  }
  return lengths;
}

DomainPolygon polygon_of(const SurfaceFrame& frame) {
  const std::vector<double> lengths = footprint_lengths(frame);
  return frame.domain == AttributeDomain::Uniform ? uniform_polygon(lengths.size()) : chordlength_polygon(lengths);
}

std::vector<Footprint> footprints_of(const SurfaceFrame& frame, const DomainPolygon& polygon) {
  std::vector<Footprint> footprints;
  footprints.reserve(polygon.corners.size());
  for (const SurfaceSide& side : frame.sides) {
    if (frame.sides.size() == 2) {
      footprints.emplace_back(polygon, footprints.size(), side, Footprint::Extent{0, 0.5});
      footprints.emplace_back(polygon, footprints.size(), side, Footprint::Extent{0.5, 1});
    } else {
      footprints.emplace_back(polygon, footprints.size(), side, Footprint::Extent{});
    }
  }
  return footprints;
}

// ---- One footprint at one place, (2.1) and (2.3)

/// The curve's place at the foot; beyond its ends it goes on straight.
Vec3 foot(const Footprint& side, double t, const PlainNumbers&) {
  const Vec3 point = side.point(std::clamp(t, 0.0, 1.0));
  return point + std::min(t, 0.0) * side.start_derivative() + std::max(t - 1, 0.0) * side.end_derivative();
}

DualVector foot(const Footprint& side, const Dual& t, const DualNumbers&) {
  const ArcLengthCurve::Place place = side.place(std::clamp(t.value, 0.0, 1.0));
  const Vec3 extension =
      std::min(t.value, 0.0) * side.start_derivative() + std::max(t.value - 1, 0.0) * side.end_derivative();
  return chained(place.point + extension, place.derivative, t);
}

Vec3 ribbon_slope(const Footprint& side, double t) { return side.conormal(std::clamp(t, 0.0, 1.0)); }

DualVector ribbon_slope(const Footprint& side, const Dual& t) {
  const auto place = side.conormal_place(std::clamp(t.value, 0.0, 1.0));
  const bool inside = t.value >= 0 && t.value <= 1;
  return chained(place.value, inside ? place.slope : Vec3(Vec3::Zero()), t);
}

/// Distance to a segment of the domain, not to its line: as the paper has it.
template <class Number>
Number segment_distance(const Number& t, const Number& h, double length) {
  const Number beyond = length * (t - at_least(at_most(t, 1.0), 0.0));
  if (value_of(beyond) == 0.0) return h;
  return square_root(h * h + beyond * beyond);
}

}  // namespace

FenceReader::FenceReader(const NormalFence& fence) : fence_(fence) {
  for (std::size_t i = 0; i + 1 < fence.normals.size(); ++i) {
    angles_.push_back(angle_between(fence.normals[i], fence.normals[i + 1]));
  }
}

Vec3 FenceReader::normal(double at, const Vec3& tangent) const {
  const Vec3 between = between_keys(at);
  const Vec3 projected = between - between.dot(tangent) * tangent;
  const double size = projected.norm();
  return size > 1e-9 ? Vec3(projected / size) : Vec3(tangent.unitOrthogonal());
}

Vec3 FenceReader::between_keys(double at) const {
  const auto next = std::ranges::upper_bound(fence_.at, at);
  if (next == fence_.at.begin()) return fence_.normals.front();
  if (next == fence_.at.end()) return fence_.normals.back();
  const auto key = static_cast<std::size_t>(next - fence_.at.begin()) - 1;
  const double part = (at - fence_.at[key]) / (fence_.at[key + 1] - fence_.at[key]);
  return turned_between(fence_.normals[key], fence_.normals[key + 1], angles_[key], part);
}

Footprint::Footprint(const DomainPolygon& polygon, std::size_t index, const SurfaceSide& side, const Extent& extent)
    : from(polygon.corners[index]), curve_(side.curve) {
  const Vec2 whole = polygon.corners[(index + 1) % polygon.corners.size()] - from;
  length = whole.norm();
  along = whole / length;
  inwards = left_of(along);
  first_ = side.reversed ? 1 - extent.begin : extent.begin;
  step_ = (side.reversed ? -1 : 1) * (extent.end - extent.begin);
  start_ = place(0);
  end_ = place(1);
  if (side.fence.empty()) return;

  const FenceReader fence(side.fence);
  const auto conormal_at = [&](double t) -> Vec3 {
    const Vec3 tangent = place(t).derivative.normalized();
    const double at = extent.begin + t * (extent.end - extent.begin);
    return side.fence.magnitude * fence.normal(at, tangent).cross(tangent);
  };
  const PiecewiseQuintic::Options options{.tolerance = 1e-9 * std::abs(side.fence.magnitude), .most_pieces = 512};
  conormals_ = std::make_shared<const PiecewiseQuintic>(conormal_at, breaks_in(side.fence, extent), options);
}

ArcLengthCurve::Place Footprint::place(double t) const {
  ArcLengthCurve::Place result = curve_->place(t >= 1 ? first_ + step_ : fraction(t));
  result.derivative *= step_;
  return result;
}

SurfaceBase::SurfaceBase(const SurfaceFrame& frame)
    : frame_(frame), polygon_(polygon_of(frame)), footprints_(footprints_of(frame, polygon_)) {
  for (const SurfaceSide& side : frame.sides) {
    sigma_ += side.curve->length();
    fences_.emplace_back(side.fence);
  }
  middle_bubble_ = 1 / boundary_weight(polygon_.centroid);
}

double SurfaceBase::depth(const Vec2& place) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Footprint& side : footprints_) least = std::min(least, (place - side.from).dot(side.inwards));
  return least;
}

double SurfaceBase::boundary_weight(const Vec2& place) const {
  double sum = 0;
  for (const Footprint& side : footprints_) {
    const double weight = side.length / (place - side.from).dot(side.inwards);
    sum += weight * weight;
  }
  return sum;
}

std::size_t SurfaceBase::footprint_under(const Vec2& place) const {
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    if ((place - footprints_[i].from).dot(footprints_[i].inwards) < on_a_side) return i;
  }
  return footprints_.size();
}

Vec3 SurfaceBase::on_footprint(std::size_t footprint, const Vec2& place) const {
  const Footprint& side = footprints_[footprint];
  const double t = (place - side.from).dot(side.along) / side.length;
  return t >= 1 - on_a_side ? side.end() : side.point(std::max(0.0, t));
}

template <class Numbers>
BaseBlend<Numbers> SurfaceBase::blend(const Vec2& place) const {
  return is_paper() ? blend_as_in_paper<Numbers>(place) : blend_by_lines<Numbers>(place);
}

/// All weights are taken times the distance to the nearest side, so that they and their derivatives stay finite at
/// that side: its own weight is its length there.
template <class Numbers>
BaseBlend<Numbers> SurfaceBase::blend_by_lines(const Vec2& place) const {
  using Number = typename Numbers::Number;
  using Vector = typename Numbers::Vector;
  const bool smooth = frame_.mode == AttributeMode::Smooth;

  // 1. The nearest side.
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    const double distance = (place - footprints_[i].from).dot(footprints_[i].inwards);
    if (distance < least) nearest = i;
    least = std::min(least, distance);
  }
  BaseBlend<Numbers> result;
  const Footprint& under = footprints_[nearest];
  result.nearness = at_least(coordinate(place, under.from, under.inwards, Number()), 0.0);

  // 2. Feet with their weights; ribbons with the squares of these.
  Number weights = 0.0;
  Number squares = 0.0;
  Vector positions = Vector(Vec3(Vec3::Zero()));
  Vector ribbons = Vector(Vec3(Vec3::Zero()));
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    const Footprint& side = footprints_[i];
    const Number t = coordinate(place, side.from, side.along, Number()) / side.length;
    const Number h = coordinate(place, side.from, side.inwards, Number());
    const Number weight = i == nearest ? Number(side.length) : side.length * result.nearness / h;
    const Vector position = foot(side, t, Numbers());
    weights += weight;
    positions += weight * position;
    const Number square = weight * weight;
    squares += square;
    if (smooth) ribbons += square * (position + (sigma_ * h) * ribbon_slope(side, t));
  }
  result.side_weight = squares;
  result.point = positions / weights;
  if (!smooth) return result;

  // 3. Between the ribbons and the blend of positions by fullness, without a change of slope at the sides.
  const Vector full = ribbons / squares;
  const Number bubble = result.nearness * result.nearness / (squares * middle_bubble_);
  result.point = full + ((1 - frame_.fullness) * bubble) * (result.point - full);
  return result;
}

template <class Numbers>
BaseBlend<Numbers> SurfaceBase::blend_as_in_paper(const Vec2& place) const {
  using Number = typename Numbers::Number;
  using Vector = typename Numbers::Vector;
  BaseBlend<Numbers> result;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    const Footprint& side = footprints_[i];
    const Number t = coordinate(place, side.from, side.along, Number()) / side.length;
    const Number h = at_least(coordinate(place, side.from, side.inwards, Number()), 0.0);
    const Number distance = segment_distance(t, h, side.length);
    if (i == 0 || value_of(distance) < value_of(result.nearness)) {
      nearest = i;
      result.nearness = distance;
    }
  }
  Number weights = 0.0;
  Vector sum = Vector(Vec3(Vec3::Zero()));
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    const Footprint& side = footprints_[i];
    const Number t = coordinate(place, side.from, side.along, Number()) / side.length;
    const Number h = at_least(coordinate(place, side.from, side.inwards, Number()), 0.0);
    const Number weight = i == nearest ? Number(1.0) : result.nearness / segment_distance(t, h, side.length);
    weights += weight;
    sum += weight * foot(side, at_most(at_least(t, 0.0), 1.0), Numbers());
  }
  result.side_weight = weights;
  result.point = sum / weights;
  return result;
}

template BaseBlend<PlainNumbers> SurfaceBase::blend<PlainNumbers>(const Vec2&) const;
template BaseBlend<DualNumbers> SurfaceBase::blend<DualNumbers>(const Vec2&) const;

std::size_t SurfaceBase::byte_size() const {
  std::size_t bytes = sizeof(*this);
  for (const Footprint& side : footprints_) bytes += side.byte_size();
  return bytes;
}

}  // namespace croquis
