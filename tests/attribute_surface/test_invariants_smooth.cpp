// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec3 normal_of(const SurfacePlace& place) { return place.du.cross(place.dv).normalized(); }

/// The normal beside a curve: at a distance h of the domain from its side of a face.
Vec3 normal_beside(const AttributeNetwork& network, const AttributeSurface& surface, Index face, Index curve,
                   double fraction, double h) {
  const std::vector<AttributeSide>& loop = network.faces[face].loop;
  const auto side = std::ranges::find(loop, curve, &AttributeSide::curve);
  const auto index = static_cast<std::size_t>(side - loop.begin());
  const FaceSurface& made = *surface.faces[face].surface;
  const double along = side->reversed ? 1 - fraction : fraction;
  const Vec2 at = made.side_place(index, along);
  const Vec2 direction = made.side_place(index, std::min(1.0, along + 0.01)) - at;
  const Vec3 normal = normal_of(made.evaluate(at + h * left_of(direction).normalized()));
  return surface.faces[face].flipped ? Vec3(-normal) : normal;
}

/// The greatest angle between both faces' normals beside a smooth curve.
double jump_beside(const AttributeNetwork& network, const AttributeSurface& surface, Index curve, double h) {
  double largest = 0;
  const std::vector<Index>& faces = surface.curves[curve].faces;
  for (const double fraction : {0.1, 0.3, 0.45, 0.7, 0.9}) {
    const Vec3 first = normal_beside(network, surface, faces[0], curve, fraction, h);
    const Vec3 second = normal_beside(network, surface, faces[1], curve, fraction, h);
    largest = std::max(largest, angle_between(first, second));
  }
  return largest;
}

/// The greatest angle between normals on both sides of the lines from corners at right angles to sides.
double crease_inside(const FaceSurface& face) {
  const DomainPolygon& domain = face.domain();
  double largest = 0;
  for (std::size_t i = 0; i < domain.corners.size(); ++i) {
    for (const std::size_t side : {i, (i + domain.corners.size() - 1) % domain.corners.size()}) {
      const Vec2 along = (domain.corners[(side + 1) % domain.corners.size()] - domain.corners[side]).normalized();
      for (const double out : {0.01, 0.02, 0.05, 0.1}) {
        const Vec2 place = domain.corners[i] + out * left_of(along);
        if (distance_inside(domain, place) < 2e-3) continue;
        const Vec3 before = normal_of(face.evaluate(place - 1e-6 * along));
        largest = std::max(largest, angle_between(before, normal_of(face.evaluate(place + 1e-6 * along))));
      }
    }
  }
  return largest;
}

AttributeSurfaceOptions options_of(AttributeMode mode) {
  AttributeSurfaceOptions options;
  options.mode = mode;
  return options;
}

}  // namespace

TEST_CASE("faces have one tangent plane along smooth curves, in the limit and in step with the distance") {
  for (const AttributeNetwork& network : joined_networks()) {
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    std::size_t smooth = 0;
    for (Index c = 0; c < network.curves.size(); ++c) {
      if (!surface.curves[c].smooth) continue;
      ++smooth;
      CAPTURE(network.curves[c].id);
      const double near = jump_beside(network, surface, c, 2e-6);
      CHECK(near < 0.1 * degree);
      CHECK(jump_beside(network, surface, c, 2e-7) < 0.2 * near + 1e-4 * degree);
    }
    const auto wished = std::ranges::count(network.curves, CurveJoin::Smooth, &AttributeCurve::join);
    CHECK(smooth == static_cast<std::size_t>(wished));
  }
}

TEST_CASE("points and inner curves leave tangent planes along smooth curves as they are") {
  for (const AttributeNetwork& plain : joined_networks()) {
    const AttributeNetwork network = with_points(plain, 2, 0.1, 21);
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    for (Index c = 0; c < network.curves.size(); ++c) {
      if (!surface.curves[c].smooth) continue;
      CAPTURE(network.curves[c].id);
      CHECK(jump_beside(network, surface, c, 2e-7) < 0.1 * degree);
    }
  }
}

TEST_CASE("a closed sphere of patches is nearly round, and its normals look outwards") {
  for (const AttributeNetwork& network : {sphere_of_octants(), cube_sphere()}) {
    CAPTURE(network.name);
    for (const SurfaceFace& face : surface_of(network).faces) {
      REQUIRE(face.surface);
      for (const FanPlace& fan : spread_places(face.surface->domain().corners.size(), 60, 2)) {
        const SurfacePlace at = face.surface->evaluate(place_in(face.surface->domain(), fan));
        CHECK(std::abs(at.point.norm() - 1) < 0.03);
        CHECK(angle_between(normal_of(at), at.point) < 8 * degree);
      }
    }
  }
}

TEST_CASE("derivatives are those of the surface") {
  for (const AttributeNetwork& plain : all_loops()) {
    if (plain.name.find("far") != std::string::npos) continue;  // differences of large numbers
    const AttributeNetwork network = with_points(plain, 2, 0.1, 6);
    CAPTURE(network.name);
    for (const AttributeMode mode : {AttributeMode::Smooth, AttributeMode::Position, AttributeMode::Paper}) {
      const FaceSurface face = first_surface(network, options_of(mode));
      for (const FanPlace& fan : spread_places(face.domain().corners.size(), 12, 8)) {
        const Vec2 place = place_in(face.domain(), fan);
        if (distance_inside(face.domain(), place) < 1e-3) continue;
        const SurfacePlace found = face.evaluate(place);
        const double h = 1e-6;
        const Vec3 du = (face.at(place + Vec2(h, 0)) - face.at(place - Vec2(h, 0))) / (2 * h);
        const Vec3 dv = (face.at(place + Vec2(0, h)) - face.at(place - Vec2(0, h))) / (2 * h);
        CHECK((found.point - face.at(place)).norm() < 1e-12 * (extent(network) + face.sigma()));
        CHECK((found.du - du).norm() < 1e-4 * (face.sigma() + du.norm()));
        CHECK((found.dv - dv).norm() < 1e-4 * (face.sigma() + dv.norm()));
      }
    }
  }
}

TEST_CASE("patches of positions have no crease inside") {
  for (std::size_t sides = 3; sides <= 12; ++sides) {
    const AttributeNetwork network = random_loop(sides, 5);
    CAPTURE(network.name);
    CHECK(crease_inside(first_surface(network, options_of(AttributeMode::Position))) < 0.05 * degree);
  }
}

TEST_CASE("patches of known surfaces hardly have creases inside, and those of the paper have") {
  double worst_of_paper = 0;
  for (const ExactPatch& patch : exact_patches()) {
    CAPTURE(patch.network.name);
    const auto crease = [&](AttributeMode mode) {
      return crease_inside(first_surface(patch.network, options_of(mode)));
    };
    CHECK(crease(AttributeMode::Position) < 0.05 * degree);
    // Beyond a side's ends its slope stays what it is there, and so has a kink.
    CHECK(crease(AttributeMode::Smooth) < 3 * degree);
    worst_of_paper = std::max(worst_of_paper, crease(AttributeMode::Paper));
  }
  CHECK(worst_of_paper > 10 * degree);
}

}  // namespace croquis::test
