// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/attribute_surface/domain_polygon.h"

using namespace croquis;

namespace {

using Lengths = std::vector<double>;

DomainPolygon polygon_of(const Lengths& lengths) { return chordlength_polygon(lengths); }

const Vec2& corner(const DomainPolygon& polygon, std::size_t index) {
  return polygon.corners[index % polygon.corners.size()];
}

Lengths over_decades(std::mt19937& random, std::size_t sides) {
  std::uniform_real_distribution<double> decade(-3, 0);
  Lengths lengths(sides);
  for (double& length : lengths) length = std::pow(10, decade(random));
  return lengths;
}

double largest_move(const DomainPolygon& a, const DomainPolygon& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double before = (a.corners[i] - a.corners[j]).norm();
      largest = std::max(largest, std::abs(before - (b.corners[i] - b.corners[j]).norm()));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("polygons of random lengths close, have these sides and are strictly convex") {
  std::mt19937 random(1);
  for (std::size_t run = 0; run < 3000; ++run) {
    const std::size_t sides = 3 + run % 10;
    const DomainPolygon polygon = polygon_of(over_decades(random, sides));
    CHECK(std::accumulate(polygon.side_lengths.begin(), polygon.side_lengths.end(), 0.0) == Approx(1).epsilon(1e-14));
    for (std::size_t i = 0; i < sides; ++i) {
      const Vec2 side = corner(polygon, i + 1) - corner(polygon, i);
      CHECK(std::abs(side.norm() - polygon.side_lengths[i]) < 1e-13);
      CHECK(cross(side, corner(polygon, i + 2) - corner(polygon, i + 1)) > 0);
      CHECK(std::abs(corner(polygon, i).norm() - polygon.radius) < 1e-13);
    }
  }
}

TEST_CASE("a polygon of three lengths is the triangle of these lengths") {
  const DomainPolygon triangle = polygon_of({3, 4, 5});
  CHECK(triangle.beta == 0);
  CHECK(triangle.radius == Approx(2.5 / 12).epsilon(1e-14));
  CHECK(cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]) ==
        Approx(12.0 / 144).epsilon(1e-13));
  const DomainPolygon obtuse = polygon_of({2, 3, 4.5});
  CHECK_FALSE(obtuse.centre_inside);
  CHECK(polygon_of({2, 3, 3.5}).centre_inside);
}

TEST_CASE("lengths that allow no polygon are moved towards equal ones") {
  CHECK(polygon_of({1, 1, 1.9}).beta == 0);
  CHECK(polygon_of({1, 1, 1.99999}).beta == Approx(0.0769).margin(5e-5));
  CHECK(polygon_of({1, 1, 3}).beta == Approx(0.4231).margin(5e-5));
  CHECK(polygon_of({1, 1e-9, 1}).beta == Approx(0.0741).margin(5e-5));
  CHECK(polygon_of({2, .5, .5, .5, .6}).beta == Approx(0.0022).margin(5e-5));
  CHECK(polygon_of({1, 0, 0, 0}).beta > 0.4);
}

TEST_CASE("the lengths' order and size don't matter for what becomes of each") {
  const DomainPolygon polygon = polygon_of({1, 2, 2.5, 0.7});
  const DomainPolygon later = polygon_of({200, 250, 70, 100});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK((corner(polygon, i + 1) - corner(polygon, i + 3)).norm() ==
          Approx((corner(later, i) - corner(later, i + 2)).norm()).epsilon(1e-13));
  }
}

TEST_CASE("polygons follow their lengths without a jump, where relaxing begins and where the centre leaves them too") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<Lengths> cases{
      {1, 1, 1.9}, {1, 1, 2 * 0.95}, {3, 4, 5}, {1, 1, std::numbers::sqrt2}, {2, .5, .5, .5, .6}};
  for (std::size_t i = 0; i < 300; ++i) cases.push_back(over_decades(random, 3 + i % 10));
  for (const Lengths& lengths : cases) {
    const double step = 1e-9 * std::accumulate(lengths.begin(), lengths.end(), 0.0);
    for (int run = 0; run < 5; ++run) {
      Lengths moved = lengths;
      for (double& length : moved) length = std::max(0.0, length + std::clamp(normal(random), -1.0, 1.0) * step);
      CHECK(largest_move(polygon_of(lengths), polygon_of(moved)) < 1e-7);
    }
  }
}

TEST_CASE("fan places and places are each other's inverse") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.02, 0.48);
  for (std::size_t sides = 3; sides <= 12; ++sides) {
    const DomainPolygon polygon = polygon_of(over_decades(random, sides));
    for (std::size_t k = 0; k < sides; ++k) {
      const FanPlace fan{k, part(random), part(random)};
      const Vec2 place = place_in(polygon, fan);
      CHECK(distance_inside(polygon, place) > 0);
      const FanPlace found = fan_place_in(polygon, place);
      CHECK(found.corner == k);
      CHECK(found.a == Approx(fan.a).epsilon(1e-9));
      CHECK(found.b == Approx(fan.b).epsilon(1e-9));
    }
    CHECK((place_in(polygon, {0, 1, 0}) - polygon.corners[0]).norm() < 1e-15);
    CHECK((place_in(polygon, {0, 0, 0}) - polygon.middle).norm() == 0);
  }
}

TEST_CASE("uniform domains have the perimeter 1") {
  for (std::size_t sides = 3; sides <= 12; ++sides) {
    const DomainPolygon polygon = uniform_polygon(sides);
    double perimeter = 0;
    for (std::size_t i = 0; i < sides; ++i) perimeter += (corner(polygon, i + 1) - corner(polygon, i)).norm();
    CHECK(perimeter == Approx(1).epsilon(1e-14));
  }
  CHECK(uniform_polygon(4).corners[2].isApprox(Vec2(0.25, 0.25)));
  CHECK(uniform_polygon(3).corners[0].isZero());
}
