// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {
namespace {

constexpr AttributeMode all_modes[] = {AttributeMode::Smooth, AttributeMode::Position, AttributeMode::Paper};
constexpr AttributeDomain all_domains[] = {AttributeDomain::Chordlength, AttributeDomain::Uniform};

Vec3 on_side(const SurfaceSide& side, double fraction) {
  return side.curve->at(side.reversed ? 1 - fraction : fraction);
}

/// How far a face is from its curves.
double boundary_error(const FaceSurface& face) {
  double largest = 0;
  for (std::size_t side = 0; side < face.frame().sides.size(); ++side) {
    for (int i = 0; i <= 40; ++i) {
      const Vec3 wanted = on_side(face.frame().sides[side], i / 40.0);
      largest = std::max(largest, (face.at(face.side_place(side, i / 40.0)) - wanted).norm());
    }
  }
  return largest;
}

AttributeSurfaceOptions options_of(AttributeMode mode, AttributeDomain domain) {
  AttributeSurfaceOptions options;
  options.mode = mode;
  options.domain = domain;
  return options;
}

}  // namespace

TEST_CASE("surfaces meet their curves, in all modes and for any number of sides") {
  for (const AttributeNetwork& network : all_loops()) {
    CAPTURE(network.name);
    for (const AttributeMode mode : all_modes) {
      for (const AttributeDomain domain : all_domains) {
        const FaceSurface face = first_surface(network, options_of(mode, domain));
        CHECK(boundary_error(face) < 1e-12 * std::max(extent(network), face.sigma()));
      }
    }
  }
}

TEST_CASE("near a side the surface is near the curve, without a jump") {
  for (const AttributeNetwork& network : all_loops()) {
    CAPTURE(network.name);
    for (const AttributeMode mode : all_modes) {
      const FaceSurface face = first_surface(network, options_of(mode, AttributeDomain::Chordlength));
      for (std::size_t side = 0; side < face.frame().sides.size(); ++side) {
        for (const double fraction : {0.1, 0.37, 0.5, 0.8}) {
          const Vec2 at = face.side_place(side, fraction);
          const Vec2 inside = at + 1e-7 * (face.domain().middle - at).normalized();
          CHECK((face.at(inside) - face.at(at)).norm() < 1e-4 * face.sigma());
        }
      }
    }
  }
}

TEST_CASE("all points of a face are met at once") {
  std::vector<AttributeNetwork> networks = joined_networks();
  for (const AttributeNetwork& network : all_loops()) networks.push_back(network);
  for (const AttributeNetwork& plain : networks) {
    const AttributeNetwork network = with_points(plain, 12, 0.15, 9);
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    for (std::size_t p = 0; p < network.points.size(); ++p) {
      const PointAttribute& point = network.points[p];
      const FaceSurface& face = *surface.faces[point.face].surface;
      REQUIRE(surface.points[p].fan);
      const Vec2 place = place_in(face.domain(), *surface.points[p].fan);
      CHECK((face.at(place) - point.point).norm() < 1e-12 * std::max(extent(network), face.sigma()));
      // Nothing sharp about it: beside the point the surface is near it.
      const Vec3 beside = face.at(place + Vec2(1e-7, 0));
      CHECK((beside - point.point).norm() < 1e-4 * face.sigma());
    }
  }
}

}  // namespace croquis::test
