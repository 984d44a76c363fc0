// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/self_intersection.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Triangle = std::array<Index, 3>;

std::vector<Index> in_order(std::size_t count) {
  std::vector<Index> corners(count);
  std::iota(corners.begin(), corners.end(), Index{0});
  return corners;
}

/// The cut's triangles by their vertices, each beginning at its lowest, whatever their order.
std::set<Triangle> cut_of(const std::vector<Vec3>& positions, const std::vector<Index>& polygon) {
  std::set<Triangle> result;
  visit_triangles(positions, polygon, [&](const Triangle& corners) {
    Triangle t = {polygon[corners[0]], polygon[corners[1]], polygon[corners[2]]};
    std::ranges::rotate(t, std::ranges::min_element(t));
    result.insert(t);
  });
  return result;
}

std::vector<Index> rotated_by(std::vector<Index> polygon, std::size_t steps) {
  std::ranges::rotate(polygon, polygon.begin() + static_cast<std::ptrdiff_t>(steps));
  return polygon;
}

/// Star-shaped around the origin, in the plane z = 0.
std::vector<Vec3> star(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(random.between(0.1, 1) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

/// Sum of the triangles' areas, and the sum of those that face along the polygon's normal less the others.
std::pair<double, double> areas_of(const std::vector<Vec3>& polygon) {
  const Vec3 normal = area_normal(polygon).normalized();
  std::pair<double, double> sum{0, 0};
  visit_triangles(polygon, in_order(polygon.size()), [&](const Triangle& t) {
    const Vec3 area = (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]) / 2;
    sum.first += area.norm();
    sum.second += area.dot(normal);
  });
  return sum;
}

void check_covered_once(const std::vector<Vec3>& polygon) {
  const double area = area_normal(polygon).norm();
  const auto [total, facing] = areas_of(polygon);
  CHECK(total == Approx(area).epsilon(1e-12));
  CHECK(facing == Approx(area).epsilon(1e-12));
  CHECK(cut_of(polygon, in_order(polygon.size())).size() == polygon.size() - 2);
}

std::vector<Vec3> comb(int teeth) {
  std::vector<Vec3> polygon = {{0, -1, 0}, {2.0 * teeth, -1, 0}};
  for (int i = teeth; i > 0; --i) {
    polygon.push_back({2.0 * i, 5, 0});
    polygon.push_back({2.0 * i - 1, 0, 0});
  }
  polygon.push_back({0, 5, 0});
  return polygon;
}

/// A bent polygon with all its lengths different.
std::vector<Vec3> bent(std::uint64_t seed, std::size_t count) {
  Random random(seed + 100);
  std::vector<Vec3> points = star(seed, count);
  for (Vec3& point : points) point.z() = random.between(-0.2, 0.2);
  return points;
}

}  // namespace

TEST_CASE("a quad is cut along its shorter diagonal, a reflex one from its reflex corner") {
  const std::vector<Vec3> raised = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  CHECK(quad_cut(raised, in_order(4)) == 1);
  const std::vector<Vec3> arrow = {{0, 0, 0}, {4, 1, 0}, {0, 8, 0}, {1, 1, 0}};  // its diagonal 0-2 lies outside
  CHECK(quad_cut(arrow, in_order(4)) == 1);
  CHECK(quad_cut(arrow, rotated_by(in_order(4), 1)) == 0);
  const std::vector<Vec3> straight = {{0, 0, 0}, {1, 0, 0}, {9, 0, 0}, {1, 1, 0}};  // 0-2 runs along the sides
  CHECK(quad_cut(straight, in_order(4)) == 1);
}

TEST_CASE("of equal diagonals that with the lowest vertex is the cut, up to rounding") {
  const std::vector<Vec3> saddle = {{1, 0, 1}, {0, 1, -1}, {-1, 0, 1}, {0, -1, -1}};
  CHECK(cut_of(saddle, {0, 1, 2, 3}) == std::set<Triangle>{{0, 1, 2}, {0, 2, 3}});
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec3> moved = saddle;
    const Eigen::AngleAxisd turn(random.between(0, 6), Vec3(random.between(-1, 1), 1, 0.3).normalized());
    for (Vec3& place : moved) place = (turn * place * 7 + Vec3(30, 2, 5)).cast<float>().cast<double>();
    CHECK(quad_cut(moved, in_order(4)) == 0);
  }
}

TEST_CASE("the cut doesn't depend on where the corners begin, nor on motions, mirrors and sizes") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::size_t count = 4 + seed % 12;
    const std::vector<Vec3> places = bent(seed, count);
    const std::vector<Index> polygon = in_order(count);
    const std::set<Triangle> expected = cut_of(places, polygon);
    CHECK(expected.size() == count - 2);
    for (std::size_t steps = 1; steps < count; ++steps) CHECK(cut_of(places, rotated_by(polygon, steps)) == expected);
    std::vector<Vec3> moved;
    for (const Vec3& place : places)
      moved.push_back(3.7 * (Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()) * place) + Vec3(100, -30, 8));
    CHECK(cut_of(moved, polygon) == expected);
    std::vector<Vec3> mirrored = places;
    for (Vec3& place : mirrored) place.x() = -place.x();
    std::vector<Index> backwards = polygon;
    std::ranges::reverse(backwards);
    std::set<Triangle> turned;
    for (const Triangle& t : expected) turned.insert({t[0], t[2], t[1]});
    CHECK(cut_of(mirrored, backwards) == turned);
  }
}

TEST_CASE("regular polygons, whose diagonals are all alike, are cut the same from every corner") {
  for (const std::size_t count : {5U, 6U, 8U, 12U, 17U, 64U}) {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      places.push_back(Vec3(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.1 : -0.1));
    }
    const std::set<Triangle> expected = cut_of(places, in_order(count));
    for (std::size_t steps = 1; steps < count; ++steps)
      CHECK(cut_of(places, rotated_by(in_order(count), steps)) == expected);
  }
}

TEST_CASE("every simple polygon is covered exactly once, concave ones and those with bridges to holes too") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) check_covered_once(star(seed, 3 + seed % 60));
  for (std::vector<Vec3> polygon :
       {comb(1), comb(20), std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}},
        std::vector<Vec3>{{0, 0, 0},
                          {4, 0, 0},
                          {4, 4, 0},
                          {0, 4, 0},
                          {0, 0, 0},
                          {1, 1, 0},
                          {1, 3, 0},
                          {3, 3, 0},
                          {3, 1, 0},
                          {1, 1, 0}}}) {
    check_covered_once(polygon);
    std::ranges::reverse(polygon);
    check_covered_once(polygon);
    for (Vec3& place : polygon) place = Vec3(place.x(), 0.6 * place.y(), 0.8 * place.y() + 0.3 * place.x());
    check_covered_once(polygon);
  }
}

TEST_CASE("corners on straight sides make no triangle without area") {
  std::vector<Vec3> square;  // four corners, three more on each side
  for (int i = 0; i < 4; ++i) square.push_back({0.25 * i, 0, 0});
  for (int i = 0; i < 4; ++i) square.push_back({1, 0.25 * i, 0});
  for (int i = 0; i < 4; ++i) square.push_back({1 - 0.25 * i, 1, 0});
  for (int i = 0; i < 4; ++i) square.push_back({0, 1 - 0.25 * i, 0});
  for (const double angle : {0.0, 0.3, 1.0}) {
    for (Vec3& place : square) place = Eigen::AngleAxisd(angle, Vec3(1, 1, 0.2).normalized()) * place;
    visit_triangles(square, in_order(16), [&](const Triangle& t) {
      CHECK((square[t[1]] - square[t[0]]).cross(square[t[2]] - square[t[0]]).norm() > 0.01);
    });
  }
}

TEST_CASE("polygons that cross themselves or have no area still get their number of triangles") {
  for (const std::vector<Vec3>& polygon :
       {std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<Vec3>(7, Vec3(1, 2, 3)),
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}}) {
    std::size_t count = 0;
    visit_triangles(polygon, in_order(polygon.size()), [&](const Triangle&) { ++count; });
    CHECK(count == polygon.size() - 2);
  }
}

TEST_CASE("vertices that should not be joined are joined only where there is no other way") {
  const std::vector<Vec3> kite = {{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}};
  const auto has_diagonal = [&](const std::function<bool(Index, Index)>& avoid, Index a, Index b) {
    const auto triangles = polygon_cut(kite, in_order(4), avoid);
    return std::ranges::all_of(
        triangles, [&](const Triangle& t) { return std::ranges::count(t, a) == 1 && std::ranges::count(t, b) == 1; });
  };
  CHECK(has_diagonal({}, 1, 3));
  CHECK(has_diagonal([](Index a, Index b) { return a == 1 && b == 3; }, 0, 2));
  CHECK(has_diagonal([](Index, Index) { return true; }, 1, 3));
}

TEST_CASE("self-intersections are those of the cut, whichever faces are asked about") {
  // A saddle whose cut is the ridge from vertex 1 to 2, in a mesh where it isn't the first to use them.
  PolyMesh mesh;
  mesh.positions = {{0, -1, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 1, -1}, {0, 0.1, 0.5}, {0, 0.4, 0.5}, {0.1, 0.2, 3}};
  mesh.add_triangle(4, 5, 6);
  mesh.add_face(std::array<Index, 4>{1, 3, 2, 0});
  Progress progress;
  const std::size_t all = find_self_intersections(mesh, progress).count;
  for (Index face = 0; face < 2; ++face)
    CHECK(find_intersections_of(mesh, std::array<Index, 1>{face}, progress).count == all);
}
