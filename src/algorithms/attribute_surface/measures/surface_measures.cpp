// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/surface_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

/// What can be measured of one face alone.
struct FaceMeasures {
  PatchMeasures patch;        ///< without the face's number and its folds
  double boundary_error = 0;  ///< model units

  std::size_t byte_size() const { return sizeof *this + patch.side_lengths.size() * sizeof(double); }
};

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

/// How far inside of both faces the normals beside a smooth curve are compared, in domains of perimeter 1.
constexpr double beside_a_curve = 2e-6;
/// Places between the ends of a curve at which they are.
constexpr int jump_places = 5;

/// The part of a curve that lies between two samples of an inner curve is measured in its middle, too.
constexpr int parts_between_knots = 2;

std::optional<double> point_error(const AttributeSurface& surface, const PointAttribute& point,
                                  const SurfacePoint& placed) {
  const auto& face = surface.faces[point.face].surface;
  if (!placed.fan || face == nullptr) return std::nullopt;
  return (face->at(place_in(face->domain(), *placed.fan)) - point.point).norm();
}

/// The largest distance of an inner curve to where the surface has its footprint.
std::optional<double> inner_error(const FaceSurface& face, const ArcLengthCurve& curve) {
  const auto placed = std::ranges::find_if(face.curves(), [&](const PlacedCurve& other) {
    return other.points.front() == curve.at(0) && other.points.back() == curve.at(1);
  });
  if (placed == face.curves().end()) return std::nullopt;
  double error = 0;
  const std::size_t parts = (placed->places.size() - 1) * parts_between_knots;
  for (std::size_t i = 0; i <= parts; ++i) {
    const std::size_t knot = std::min(i / parts_between_knots, placed->places.size() - 2);
    const double along = static_cast<double>(i - knot * parts_between_knots) / parts_between_knots;
    const Vec2 place = (1 - along) * placed->places[knot] + along * placed->places[knot + 1];
    const Vec3 wanted = curve.at(static_cast<double>(i) / static_cast<double>(parts));
    error = std::max(error, (face.at(place) - wanted).norm());
  }
  return error;
}

/// A curve as one of its faces has it.
struct CurveUse {
  const FaceSurface* face = nullptr;
  std::size_t side = 0;
  bool reversed = false;
};

CurveUse use_of(const AttributeNetwork& network, const AttributeSurface& surface, Index face, Index curve) {
  const auto& loop = network.faces[face].loop;
  const auto found = std::ranges::find(loop, curve, &AttributeSide::curve);
  return {surface.faces[face].surface.get(), static_cast<std::size_t>(found - loop.begin()), found->reversed};
}

/// The surface's normal just inside of a curve.
/// @param s along the curve's own direction
Vec3 normal_beside(const CurveUse& use, double s) {
  const double along = use.reversed ? 1 - s : s;
  const Vec2 place = use.face->side_place(use.side, along);
  const Vec2 tangent = use.face->side_place(use.side, along + 1e-3) - use.face->side_place(use.side, along - 1e-3);
  return use.face->normal(place + beside_a_curve * left_of(tangent.normalized()));
}

/// The largest angle of the normals of both faces; they run along the curve in opposite directions, or their normals
/// point to opposite sides.
double normal_jump(const CurveUse& first, const CurveUse& second) {
  const double sign = first.reversed == second.reversed ? -1 : 1;
  double jump = 0;
  for (int i = 1; i <= jump_places; ++i) {
    const double s = static_cast<double>(i) / (jump_places + 1);
    jump = std::max(jump, angle_between(normal_beside(first, s), sign * normal_beside(second, s)));
  }
  return jump;
}

}  // namespace

SurfaceMeasures measure(const AttributeNetwork& network, const AttributeSurface& surface, StageCache* cache) {
  SurfaceMeasures measures;
  measures.inner_errors.resize(network.faces.size());
  for (Index f = 0; f < network.faces.size(); ++f) {
    const SurfaceFace& face = surface.faces[f];
    if (face.surface == nullptr) continue;
    const auto measured = cached<FaceMeasures>(
        cache, "measures of a surface", StageKey().add(face.content), [&] { return measure_face(*face.surface); },
        [](const FaceMeasures& made) { return made.byte_size(); });
    measures.boundary_error = std::max(measures.boundary_error, measured->boundary_error);
    PatchMeasures& patch = measures.patches.emplace_back(measured->patch);
    patch.face = f;
    patch.folded = face.folded;
    for (const InnerCurve& inner : network.faces[f].inner) {
      const auto& curve = surface.curves[inner.curve].curve;
      measures.inner_errors[f].push_back(curve == nullptr ? std::nullopt : inner_error(*face.surface, *curve));
    }
  }
  for (std::size_t p = 0; p < network.points.size(); ++p)
    measures.point_errors.push_back(point_error(surface, network.points[p], surface.points[p]));
  for (Index c = 0; c < network.curves.size(); ++c) {
    const SurfaceCurve& curve = surface.curves[c];
    std::optional<double>& jump = measures.normal_jumps.emplace_back();
    if (!curve.smooth) continue;
    jump = normal_jump(use_of(network, surface, curve.faces[0], c), use_of(network, surface, curve.faces[1], c));
    measures.largest_normal_jump = std::max(measures.largest_normal_jump, *jump);
  }
  return measures;
}

}  // namespace croquis
