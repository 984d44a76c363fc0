// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/gallery.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"

namespace croquis::test {
namespace {

std::vector<AttributeNetwork> every_network() {
  std::vector<AttributeNetwork> all = all_loops();
  for (const AttributeNetwork& network : joined_networks()) all.push_back(network);
  for (const ExactPatch& patch : exact_patches()) all.push_back(patch.network);
  for (const AttributeNetwork& network : gallery_networks()) all.push_back(network);
  all.push_back(l_loop());
  return all;
}

/// How often each curve is walked along forwards and backwards.
std::map<Index, std::pair<int, int>> uses_of(const AttributeNetwork& network) {
  std::map<Index, std::pair<int, int>> uses;
  for (const AttributeFace& face : network.faces) {
    for (const AttributeSide& side : face.loop) ++(side.reversed ? uses[side.curve].second : uses[side.curve].first);
  }
  return uses;
}

/// The triangle fan around a face's corners: twice its area along the normal.
Vec3 newell(const AttributeNetwork& network, const AttributeFace& face) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < face.loop.size(); ++i) {
    const auto start = [&](std::size_t k) {
      const AttributeSide& side = face.loop[k % face.loop.size()];
      const AttributeCurve& curve = network.curves[side.curve];
      return network.nodes[side.reversed ? curve.to : curve.from].point;
    };
    sum += start(i).cross(start(i + 1));
  }
  return sum;
}

}  // namespace

TEST_CASE("networks are valid, and their loops close") {
  for (const AttributeNetwork& network : every_network()) {
    CAPTURE(network.name);
    CHECK(validate(network).empty());
    for (const AttributeFace& face : network.faces) {
      for (std::size_t i = 0; i < face.loop.size(); ++i) {
        const AttributeSide &side = face.loop[i], &next = face.loop[(i + 1) % face.loop.size()];
        const AttributeCurve &curve = network.curves[side.curve], &other = network.curves[next.curve];
        CHECK((side.reversed ? curve.from : curve.to) == (next.reversed ? other.to : other.from));
      }
    }
  }
}

TEST_CASE("curves of exact patches lie on their surfaces") {
  const std::vector<ExactPatch> patches = exact_patches();
  CHECK(patches.size() == 11);
  for (const ExactPatch& patch : patches) {
    CAPTURE(patch.network.name);
    for (const AttributeCurve& curve : patch.network.curves) {
      for (int i = 0; i <= 40; ++i) {
        const Vec3 place = bezier_point(control_polygon(patch.network, curve), i / 40.0);
        CHECK((place - patch.nearest(place)).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("places nearest to points beside a surface are at right angles to it") {
  const Vec3 beside(0.3, -0.4, 0.5);
  for (const NearestOnSurface nearest : {nearest_on_saddle, nearest_on_hood, nearest_on_sphere}) {
    const Vec3 foot = nearest(beside);
    CHECK((nearest(foot) - foot).norm() < 1e-12);
    const Vec3 half_way = nearest(0.5 * (foot + beside));
    CHECK((half_way - foot).norm() < 1e-12);
  }
  const Vec3 tube = nearest_on_torus({2.5, 0.4, 0.9});
  CHECK((nearest_on_torus(tube) - tube).norm() < 1e-12);
}

TEST_CASE("closed networks have every curve in two faces, once in each direction, and look outwards") {
  for (const AttributeNetwork& network : {sphere_of_octants(), cube_sphere(), torus_of_quads(6, 4)}) {
    CAPTURE(network.name);
    const auto uses = uses_of(network);
    CHECK(uses.size() == network.curves.size());
    for (const auto& [curve, use] : uses) CHECK(use == std::pair(1, 1));
    const bool ball = network.faces.size() <= 8;
    for (const AttributeFace& face : network.faces) {
      const AttributeCurve& first = network.curves[face.loop[0].curve];
      CHECK((!ball || newell(network, face).dot(network.nodes[first.from].point) > 0));
    }
  }
}

TEST_CASE("the car has the faces and curves that it is said to have") {
  const AttributeNetwork car = example_network("car_crashed");
  CHECK(car.nodes.size() == 32);
  CHECK(car.curves.size() == 52);
  CHECK(car.faces.size() == 21);
  CHECK(car.points.size() == 4);
  const auto uses = uses_of(car);
  const auto shared =
      std::ranges::count_if(uses, [](const auto& use) { return use.second.first + use.second.second == 2; });
  CHECK(shared == 38);
}

}  // namespace croquis::test
