// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/gallery.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A face with one inner curve: places of the true surface over a line of its domain, lifted in the middle.
AttributeNetwork with_inner_curve(const ExactPatch& patch, InnerProfile profile) {
  AttributeNetwork network = patch.network;
  const FaceSurface face = first_surface(network);
  const DomainPolygon& domain = face.domain();
  AttributeCurve curve{"inner", no_index, no_index, {}, CurveJoin::Crease};
  const Vec2 along = (domain.corners[1] - domain.corners[0]).normalized();
  const double half = 0.6 * distance_inside(domain, domain.middle);
  for (int i = 0; i < 4; ++i) {
    const SurfacePlace at = face.evaluate(domain.middle + (2 * i / 3.0 - 1) * half * along);
    const double height = i == 1 || i == 2 ? 0.3 * half * face.sigma() : 0;
    curve.control.emplace_back(at.point + height * at.du.cross(at.dv).normalized());
  }
  network.curves.push_back(curve);
  network.faces[0].inner.push_back({static_cast<Index>(network.curves.size() - 1), profile, {}});
  return network;
}

/// The greatest distance of places of an inner curve from the surface.
double distance_from(const FaceSurface& face, const ArcLengthCurve& curve, int parts, double offset) {
  double largest = 0;
  for (int i = 0; i < parts; ++i) {
    const Vec3 place = curve.at((i + offset) / parts);
    largest = std::max(largest, nearest_place(face, place).distance);
  }
  return largest;
}

}  // namespace

TEST_CASE("inner curves are met, round or in a ridge, and leave the sides alone") {
  for (const ExactPatch& patch : exact_patches()) {
    for (const InnerProfile profile : {InnerProfile::Smooth, InnerProfile::Sharp}) {
      const AttributeNetwork network = with_inner_curve(patch, profile);
      CAPTURE(network.name);
      const AttributeSurface surface = surface_of(network);
      const FaceSurface& face = *surface.faces[0].surface;
      REQUIRE(face.curves().size() == 1);
      const PlacedCurve& placed = face.curves()[0];
      for (std::size_t i = 0; i < placed.places.size(); ++i)
        CHECK((face.at(placed.places[i]) - placed.points[i]).norm() < 1e-10 * face.sigma());
      CHECK(distance_from(face, *surface.curves.back().curve, 16, 0.25) < 2e-4 * face.sigma());
    }
  }
}

TEST_CASE("a point's normal is the surface's there, and the point is met all the same") {
  const Vec3 wanted = Vec3(0.2, -0.3, 1).normalized();
  for (const PointProfile profile : {PointProfile::Smooth, PointProfile::Cone}) {
    for (const std::size_t sides : std::vector<std::size_t>{3, 4, 5, 8}) {
      AttributeNetwork network = random_loop(sides, 60);
      const FaceSurface before = first_surface(network);
      const FanPlace fan{1, 0.2, 0.3};
      const Vec3 place = before.at(place_in(before.domain(), fan)) + Vec3(0, 0, 0.1);
      network.points.push_back({"p", 0, place, fan, {}, profile, 7 * wanted});
      const FaceSurface face = first_surface(network);
      const Vec2 at = place_in(face.domain(), fan);
      CHECK((face.at(at) - place).norm() < 1e-12 * face.sigma());
      if (profile == PointProfile::Cone) continue;  // has no tangent plane but in the limit of no height
      for (const double angle : {0.0, 1.0, 2.0, 4.0}) {
        const Vec2 beside = at + 1e-6 * Vec2(std::cos(angle), std::sin(angle));
        const Vec3 normal = face.normal(beside);
        CHECK(std::min(angle_between(normal, wanted), angle_between(-normal, wanted)) < 0.1 * degree);
      }
    }
  }
}

TEST_CASE("slopes that are given are the surface's along the curve, in both faces of a smooth one") {
  AttributeNetwork network = cube_sphere();
  const Index curve = network.faces[0].loop[0].curve;
  const Vec3 middle = bezier_point(network.curves[curve].control, 0.5);
  const Vec3 tangent = (network.curves[curve].control.back() - network.curves[curve].control.front()).normalized();
  const Vec3 turned = Eigen::AngleAxisd(0.3, tangent) * middle;
  network.slopes.push_back({curve, no_index, {0.5}, {turned}, 1});
  const AttributeSurface surface = surface_of(network);
  REQUIRE(surface.findings.empty());
  for (const Index f : surface.curves[curve].faces) {
    const auto& loop = network.faces[f].loop;
    const auto side = static_cast<std::size_t>(std::ranges::find(loop, curve, &AttributeSide::curve) - loop.begin());
    const FaceSurface& face = *surface.faces[f].surface;
    CHECK(angle_between(face.side_normal(side, 0.5), turned) < 1e-6);
    const Vec2 inwards = (face.domain().middle - face.side_place(side, 0.5)).normalized();
    const SurfacePlace at = face.evaluate(face.side_place(side, 0.5) + 1e-7 * inwards);
    CHECK(angle_between(at.du.cross(at.dv), turned) < 0.1 * degree);
  }
}

TEST_CASE("a slope's magnitude tells how far its face follows it") {
  AttributeNetwork network = exact_patches()[0].network;
  double before = 0;
  for (const double magnitude : {0.2, 0.6, 1.0, 1.4}) {
    network.slopes.clear();
    for (Index c = 0; c < network.curves.size(); ++c) network.slopes.push_back({c, no_index, {}, {}, magnitude});
    const FaceSurface face = first_surface(network);
    const double height = face.at(face.domain().middle).norm();
    CHECK(height > before);
    before = height;
  }
}

TEST_CASE("the nearest place of the surface is where its points came from") {
  std::vector<AttributeNetwork> networks{gallery_sail()};
  for (const ExactPatch& patch : exact_patches()) networks.push_back(patch.network);
  for (const AttributeNetwork& network : networks) {
    CAPTURE(network.name);
    const FaceSurface face = first_surface(network);
    for (const FanPlace& fan : spread_places(face.domain().corners.size(), 30, 3)) {
      const Vec2 place = place_in(face.domain(), fan);
      if (distance_inside(face.domain(), place) < 2e-3) continue;
      const SurfacePlace at = face.evaluate(place);
      const Vec3 above = at.point + 0.005 * face.sigma() * at.du.cross(at.dv).normalized();
      const NearestPlace found = nearest_place(face, above);
      CHECK((found.place - place).norm() < 1e-6);
      CHECK(found.distance == Approx(0.005 * face.sigma()).epsilon(1e-6));
    }
  }
}

}  // namespace croquis::test
