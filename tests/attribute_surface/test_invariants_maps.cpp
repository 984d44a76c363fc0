// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
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

/// Where a place of a face's domain is after a change of its loop.
using Renumber = std::function<FanPlace(const FanPlace& fan, std::size_t corners)>;

/// Corners per side of the loop: a face of two sides has four corners.
std::size_t corners_per_side(const AttributeFace& face) { return face.loop.size() == 2 ? 2 : 1; }

void rotate_loop(AttributeNetwork& network, std::size_t f) {
  AttributeFace& face = network.faces[f];
  std::ranges::rotate(face.loop, face.loop.begin() + 1);
}

void reverse_loop(AttributeNetwork& network, std::size_t f) {
  AttributeFace& face = network.faces[f];
  std::ranges::reverse(face.loop);
  for (AttributeSide& side : face.loop) side.reversed = !side.reversed;
}

FanPlace reversed(const FanPlace& fan, std::size_t corners) { return {corners - 1 - fan.corner, fan.b, fan.a}; }

/// Greatest distance between the same places of two networks' faces; `renumber` is for one face.
double difference(const AttributeNetwork& before, const AttributeNetwork& after, std::size_t changed,
                  const Renumber& renumber) {
  const AttributeSurface first = surface_of(before), second = surface_of(after);
  double largest = 0;
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    const FaceSurface &a = *first.faces[f].surface, &b = *second.faces[f].surface;
    const std::size_t corners = a.domain().corners.size();
    for (const FanPlace& fan : spread_places(corners, 24, f)) {
      const FanPlace other = f == changed ? renumber(fan, corners) : fan;
      largest = std::max(largest, (a.at(place_in(a.domain(), fan)) - b.at(place_in(b.domain(), other))).norm());
    }
  }
  return largest;
}

void renumber_points(AttributeNetwork& network, std::size_t face, std::size_t corners, const Renumber& renumber) {
  for (PointAttribute& point : network.points) {
    if (point.face == face) point.fan = renumber(*point.fan, corners);
  }
}

/// Loops of all sides, and a car with points: which faces' loops are changed.
template <typename Check>
void for_changed_faces(Check&& check) {
  for (const AttributeNetwork& plain : all_loops()) check(with_points(plain, 3, 0.1, 2), 0);
  const AttributeNetwork car = with_points(example_network("car_intact"), 2, 0.05, 3);
  for (std::size_t f = 0; f < car.faces.size(); f += 4) check(car, f);
  check(with_points(boat_hull(), 2, 0.1, 3), 1);
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

TEST_CASE("it doesn't matter with which curve a loop begins") {
  for_changed_faces([](const AttributeNetwork& network, std::size_t f) {
    CAPTURE(network.name, f);
    const std::size_t corners = domain_corners(network.faces[f]), step = corners_per_side(network.faces[f]);
    const Renumber renumber = [&](const FanPlace& fan, std::size_t count) {
      return FanPlace{(fan.corner + count - step) % count, fan.a, fan.b};
    };
    AttributeNetwork changed = network;
    rotate_loop(changed, f);
    renumber_points(changed, f, corners, renumber);
    CHECK(difference(network, changed, f, renumber) < 1e-12 * (1 + extent(network)));
  });
}

TEST_CASE("a loop walked the other way round gives the same surface") {
  for_changed_faces([](const AttributeNetwork& network, std::size_t f) {
    CAPTURE(network.name, f);
    AttributeNetwork changed = network;
    reverse_loop(changed, f);
    renumber_points(changed, f, domain_corners(network.faces[f]), reversed);
    CHECK(difference(network, changed, f, reversed) < 1e-12 * (1 + extent(network)));
  });
}

TEST_CASE("loops walked the other way round turn normals round") {
  for (const std::size_t sides : std::vector<std::size_t>{2, 3, 5, 8}) {
    const AttributeNetwork network = random_loop(sides, 4);
    AttributeNetwork changed = network;
    reverse_loop(changed, 0);
    const FaceSurface before = first_surface(network), after = first_surface(changed);
    for (const FanPlace& fan : spread_places(before.domain().corners.size(), 20, 1)) {
      const FanPlace other = reversed(fan, before.domain().corners.size());
      const Vec3 normal = before.normal(place_in(before.domain(), fan));
      CHECK((normal + after.normal(place_in(after.domain(), other))).norm() < 1e-9);
    }
  }
}

TEST_CASE("it doesn't matter in which direction curves were drawn") {
  for_changed_faces([](const AttributeNetwork& network, std::size_t f) {
    CAPTURE(network.name, f);
    AttributeNetwork changed = network;
    const Index turned = network.faces[f].loop[0].curve;
    AttributeCurve& curve = changed.curves[turned];
    std::swap(curve.from, curve.to);
    std::ranges::reverse(curve.control);
    for (AttributeFace& face : changed.faces) {
      for (AttributeSide& side : face.loop) side.reversed = side.reversed != (side.curve == turned);
    }
    const Renumber same = [](const FanPlace& fan, std::size_t) { return fan; };
    CHECK(difference(network, changed, f, same) < 1e-12 * (1 + extent(network)));
  });
}

}  // namespace croquis::test
