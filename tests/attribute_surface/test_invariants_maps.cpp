// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <catch2/catch.hpp>

#include "croquis/geometry/affine3.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"
#include "support/random.h"

namespace croquis::test {
namespace {

Affine3 any_similarity(Random& random) {
  Affine3 map;
  const Vec3 axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  const double factor = std::pow(10, random.between(-2, 2));
  map.linear = factor * Eigen::AngleAxisd(random.between(0, 3), axis.normalized()).toRotationMatrix();
  map.offset = factor * Vec3(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
  return map;
}

/// Greatest distance between mapped places of a network's faces and those of the mapped network.
double difference_after(const AttributeNetwork& network, const Affine3& map, const AttributeSurfaceOptions& options) {
  const AttributeSurface before = surface_of(network, options);
  const AttributeSurface after = surface_of(transformed(network, map), options);
  double largest = 0;
  for (std::size_t f = 0; f < network.faces.size(); ++f) {
    const FaceSurface &first = *before.faces[f].surface, &second = *after.faces[f].surface;
    for (const FanPlace& fan : spread_places(first.domain().corners.size(), 40, f)) {
      const Vec3 expected = map(first.at(place_in(first.domain(), fan)));
      largest = std::max(largest, (second.at(place_in(second.domain(), fan)) - expected).norm());
    }
  }
  return largest;
}

AttributeSurfaceOptions options_of(AttributeMode mode) {
  AttributeSurfaceOptions options;
  options.mode = mode;
  return options;
}

std::vector<AttributeNetwork> everything() {
  std::vector<AttributeNetwork> networks = joined_networks();
  for (const AttributeNetwork& network : all_loops()) networks.push_back(network);
  return networks;
}

/// The plane through places, and how far the farthest is from it.
double out_of_plane(const std::vector<Vec3>& places) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& place : places) middle += place / static_cast<double>(places.size());
  Eigen::MatrixXd rows(places.size(), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = (places[i] - middle).transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(rows, Eigen::ComputeThinV);
  return (rows * decomposition.matrixV().col(2)).cwiseAbs().maxCoeff();
}

std::vector<Vec3> places_on(const FaceSurface& face, std::size_t count) {
  std::vector<Vec3> places;
  for (const FanPlace& fan : spread_places(face.domain().corners.size(), count, 3))
    places.push_back(face.at(place_in(face.domain(), fan)));
  return places;
}

}  // namespace

TEST_CASE("similarities of the network are similarities of the surface") {
  Random random(31);
  for (const AttributeNetwork& plain : everything()) {
    // Places far from the origin lose digits before anything is computed.
    if (plain.name.find("far") != std::string::npos) continue;
    const AttributeNetwork network = with_points(plain, 3, 0.1, 4);
    CAPTURE(network.name);
    for (const AttributeMode mode : {AttributeMode::Smooth, AttributeMode::Position, AttributeMode::Paper}) {
      const Affine3 map = any_similarity(random);
      const double size = std::cbrt(map.linear.determinant()) * (extent(network) + 4);
      CHECK(difference_after(network, map, options_of(mode)) < 1e-12 * size);
    }
  }
}

TEST_CASE("the same network far from the origin gives the same surface, to the digits that are left") {
  for (const std::size_t sides : std::vector<std::size_t>{3, 4, 7}) {
    const AttributeNetwork network = random_loop(sides, 8);
    Affine3 move;
    move.offset = {1e5, -2e5, 5e4};
    CHECK(difference_after(network, move, {}) < 1e-9);
  }
}

TEST_CASE("a flat polygon in a circle is mapped without any distortion") {
  for (std::size_t sides = 3; sides <= 12; ++sides) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const AttributeNetwork network = cyclic_polygon(sides, seed);
      CAPTURE(network.name);
      for (const AttributeMode mode : {AttributeMode::Smooth, AttributeMode::Position}) {
        const FaceSurface face = first_surface(network, options_of(mode));
        REQUIRE(face.domain().beta == 0);
        const std::vector<FanPlace> fans = spread_places(sides, 30, seed);
        for (std::size_t i = 0; i + 1 < fans.size(); ++i) {
          const Vec2 a = place_in(face.domain(), fans[i]), b = place_in(face.domain(), fans[i + 1]);
          const double error = (face.at(a) - face.at(b)).norm() - face.sigma() * (a - b).norm();
          CHECK(std::abs(error) < 1e-12 * (extent(network) + face.sigma()));
        }
      }
    }
  }
}

TEST_CASE("positions reproduce every affine map of the domain") {
  Random random(77);
  for (std::size_t sides = 3; sides <= 12; ++sides) {
    const DomainPolygon domain = uniform_polygon(sides);
    Eigen::Matrix<double, 3, 2> map;
    for (int i = 0; i < 6; ++i) map(i / 2, i % 2) = random.between(-2, 2);
    SurfaceFrame frame;
    frame.mode = AttributeMode::Position;
    frame.domain = AttributeDomain::Uniform;
    for (std::size_t i = 0; i < sides; ++i) {
      const std::vector<Vec3> control{map * domain.corners[i], map * domain.corners[(i + 1) % sides]};
      frame.sides.push_back({std::make_shared<ArcLengthCurve>(control), false, {}});
    }
    const FaceSurface face(frame);
    for (const FanPlace& fan : spread_places(sides, 40, sides)) {
      const Vec2 place = place_in(face.domain(), fan);
      CHECK((face.at(place) - map * place).norm() < 1e-13);
    }
  }
}

TEST_CASE("flat loops stay flat") {
  for (std::size_t sides = 2; sides <= 12; ++sides) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const AttributeNetwork network = flat_loop(sides, seed);
      CAPTURE(network.name);
      for (const AttributeMode mode : {AttributeMode::Smooth, AttributeMode::Position, AttributeMode::Paper}) {
        const FaceSurface face = first_surface(network, options_of(mode));
        CHECK(out_of_plane(places_on(face, 60)) < 1e-12 * (extent(network) + face.sigma()));
      }
    }
  }
}

}  // namespace croquis::test
