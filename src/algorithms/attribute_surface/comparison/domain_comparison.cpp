// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/domain_comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr int dent_rays = 96;
constexpr int dent_rings = 96;
constexpr double dent_reach = 3;       // × radius: points move nothing beyond
constexpr double half_height = 0.5;    // of the point's way
constexpr double least_height = 1e-9;  // × the loop's length: less is no dent

/// Sums over the part of the surface that has moved far enough, on the plane across the point's way.
struct DentSums {
  double area = 0;
  Vec2 first = Vec2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Vec2& at, double weight) {
    area += weight;
    first += weight * at;
    second += weight * at * at.transpose();
  }

  Vec2 middle() const { return first / area; }

  double anisotropy() const {
    const Vec2 mean = middle();
    const Eigen::Matrix2d spread = second / area - mean * mean.transpose();
    const Vec2 axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues();
    return axes.x() > 0 ? std::sqrt(axes.y() / axes.x()) : 1;
  }
};

/// The plane across a direction, with its origin.
struct AcrossPlane {
  Vec3 origin;
  Vec3 u;
  Vec3 v;

  AcrossPlane(const Vec3& foot, const Vec3& way) : origin(foot), u(way.unitOrthogonal()), v(way.cross(u)) {}
  Vec2 operator()(const Vec3& place) const { return {(place - origin).dot(u), (place - origin).dot(v)}; }
};

}  // namespace

std::optional<DentMeasures> measure_dent(const FaceSurface& face, std::size_t point, const Vec3& foot) {
  const PlacedPoint& pulled = face.points()[point];
  const FaceSurface alone = face.with({pulled}, {});
  const Vec3 way = pulled.point - alone.base_at(pulled.place);
  const double height = way.norm();
  if (!(height > least_height * face.sigma()) || !pulled.radius) return std::nullopt;
  const Vec3 direction = way / height;
  const AcrossPlane across(foot, direction);
  const double reach = dent_reach * *pulled.radius / face.sigma();
  DentSums sums;
  for (int ring = 0; ring < dent_rings; ++ring) {
    const double r = reach * (ring + 0.5) / dent_rings;
    for (int ray = 0; ray < dent_rays; ++ray) {
      const double angle = 2 * std::numbers::pi * ray / dent_rays;
      const Vec2 place = pulled.place + r * Vec2(std::cos(angle), std::sin(angle));
      if (!(distance_inside(face.domain(), place) > 0)) continue;
      const SurfacePlace base = alone.evaluate_base(place);
      if ((alone.at(place) - base.point).dot(direction) < half_height * height) continue;
      sums.add(across(base.point), r * base.du.cross(base.dv).norm());
    }
  }
  if (!(sums.area > 0)) return std::nullopt;
  return DentMeasures{sums.middle().norm(), sums.anisotropy()};
}

std::optional<std::size_t> placed_index(const AttributeNetwork& network, const AttributeSurface& surface, Index point) {
  const PointAttribute& attribute = network.points[point];
  if (!surface.points[point].fan || !surface.faces[attribute.face].surface) return std::nullopt;
  std::size_t before = 0;
  for (Index other = 0; other < point; ++other) {
    if (network.points[other].face == attribute.face && surface.points[other].fan) ++before;
  }
  return before < surface.faces[attribute.face].surface->points().size() ? std::optional(before) : std::nullopt;
}

namespace {

/// The network on uniform domains, its points where they were put; base: the same without points.
AttributeNetwork on_uniform_domains(AttributeNetwork network, const AttributeSurface& surface,
                                    const AttributeSurface& base) {
  for (AttributeFace& face : network.faces) face.domain = AttributeDomain::Uniform;
  for (Index i = 0; i < network.points.size(); ++i) {
    const auto placed = placed_index(network, surface, i);
    PointAttribute& point = network.points[i];
    const auto& uniform = base.faces[point.face].surface;
    if (!placed || !uniform) continue;
    const FaceSurface& own = *surface.faces[point.face].surface;
    const Vec3 foot = own.base_at(own.points()[*placed].place);
    point.fan = fan_place_in(uniform->domain(), nearest_base_place(*uniform, foot).place);
    point.radius = own.points()[*placed].radius;
  }
  return network;
}

AttributeNetwork without_points(AttributeNetwork network) {
  network.points.clear();
  return network;
}

}  // namespace

DomainComparison compare_with_uniform(const AttributeNetwork& network, const AttributeSurface& surface,
                                      Progress& progress) {
  AttributeSurfaceOptions options;
  options.domain = AttributeDomain::Uniform;
  const AttributeSurface base = make_attribute_surface(without_points(network), progress, options);
  DomainComparison compared{on_uniform_domains(network, surface, base), {}, {}};
  compared.surface = make_attribute_surface(compared.network, progress);
  for (Index i = 0; i < network.points.size(); ++i) {
    progress.check();
    const auto own = placed_index(network, surface, i);
    const auto uniform = placed_index(compared.network, compared.surface, i);
    if (!own || !uniform) continue;
    const FaceSurface& face = *surface.faces[network.points[i].face].surface;
    const Vec3 foot = face.base_at(face.points()[*own].place);
    compared.points.push_back({network.points[i].id, measure_dent(face, *own, foot),
                               measure_dent(*compared.surface.faces[network.points[i].face].surface, *uniform, foot)});
  }
  return compared;
}

}  // namespace croquis
