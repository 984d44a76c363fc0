// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/face_surface.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/blend/surface_attributes.h"
#include "algorithms/attribute_surface/blend/surface_base.h"

namespace croquis {
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
