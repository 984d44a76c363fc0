// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/measures/patch_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Places per side at which a surface is compared with its curve.
constexpr std::size_t boundary_places = 8;
/// Rings of the fan in whose triangles the stretch of a map is measured.
constexpr std::size_t stretch_rings = 4;

std::vector<double> side_lengths(const SurfaceFrame& frame) {
  std::vector<double> lengths;
  for (const SurfaceSide& side : frame.sides) {
    const double length = side.curve->length();
    if (frame.sides.size() == 2) lengths.insert(lengths.end(), {length / 2, length / 2});
    if (frame.sides.size() > 2) lengths.push_back(length);
  }
  return lengths;
}

double boundary_error(const FaceSurface& surface) {
  double error = 0;
  for (std::size_t k = 0; k < surface.frame().sides.size(); ++k) {
    const SurfaceSide& side = surface.frame().sides[k];
    for (std::size_t i = 0; i <= boundary_places; ++i) {
      const double s = static_cast<double>(i) / boundary_places;
      const Vec3 wanted = side.curve->at(side.reversed ? 1 - s : s);
      error = std::max(error, (surface.at(surface.side_place(k, s)) - wanted).norm());
    }
  }
  return error;
}

/// The greatest stretch of a map over the least.
double stretch_ratio(const SurfacePlace& place) {
  const double uu = place.du.squaredNorm(), uv = place.du.dot(place.dv), vv = place.dv.squaredNorm();
  const double area = place.du.cross(place.dv).norm();  // the product of both
  const double greatest_squared = 0.5 * (uu + vv + std::hypot(uu - vv, 2 * uv));
  return area > 0 ? greatest_squared / area : std::numeric_limits<double>::infinity();
}

/// Calls `visit` with the middles of the triangles of a fan, which all have the same area within a sector.
template <typename Visit>
void each_middle(const DomainPolygon& domain, const Visit& visit) {
  const double step = 1.0 / stretch_rings;
  for (std::size_t k = 0; k < domain.corners.size(); ++k) {
    for (std::size_t i = 0; i < stretch_rings; ++i) {
      for (std::size_t j = 0; i + j < stretch_rings; ++j) {
        const double a = static_cast<double>(i), b = static_cast<double>(j);
        visit(place_in(domain, {k, (a + 1.0 / 3) * step, (b + 1.0 / 3) * step}), k);
        if (i + j + 1 < stretch_rings) visit(place_in(domain, {k, (a + 2.0 / 3) * step, (b + 2.0 / 3) * step}), k);
      }
    }
  }
}

double sector_area(const DomainPolygon& domain, std::size_t k) {
  const Vec2 next = domain.corners[(k + 1) % domain.corners.size()];
  return 0.5 * cross(domain.corners[k] - domain.middle, next - domain.middle);
}

double anisotropy(const FaceSurface& surface) {
  double sum = 0, weight = 0;
  each_middle(surface.domain(), [&](const Vec2& place, std::size_t sector) {
    const double ratio = stretch_ratio(surface.evaluate(place));
    if (!std::isfinite(ratio)) return;
    const double area = sector_area(surface.domain(), sector);
    sum += area * std::log(std::max(1.0, ratio));
    weight += area;
  });
  return weight > 0 ? std::exp(sum / weight) : 1;
}

}  // namespace

FaceMeasures measure_face(const FaceSurface& surface) {
  FaceMeasures measures;
  const DomainPolygon& domain = surface.domain();
  measures.patch.side_lengths = side_lengths(surface.frame());
  measures.patch.beta = domain.beta;
  measures.patch.radius = domain.radius;
  measures.patch.centre_inside = domain.centre_inside;
  measures.patch.sigma = surface.sigma();
  measures.patch.anisotropy = anisotropy(surface);
  measures.boundary_error = boundary_error(surface);
  return measures;
}

}  // namespace croquis
