// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Constraints = std::vector<std::array<Index, 2>>;

std::vector<Vec2> scattered(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Vec2> points;
  while (points.size() < count) points.emplace_back(random.between(0, 1), random.between(0, 1));
  return points;
}

/// A square with a diagonal, and points inside.
const std::vector<Vec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1.5, 0.5}, {0.5, 1.5}};

}  // namespace

TEST_CASE("triangles fill the convex hull, turn left, and know their neighbours") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vec2> points = scattered(seed, 60);
    const PlanarTriangulation flat = triangulate(points, {}).triangulation;
    double area = 0;
    std::size_t hull_edges = 0;
    for (Index t = 0; t < flat.triangles.size(); ++t) {
      const auto& [a, b, c] = flat.triangles[t];
      REQUIRE(orientation(points[a], points[b], points[c]) > 0);
      area += signed_area(std::array{points[a], points[b], points[c]});
      for (const Index neighbour : flat.neighbours[t]) {
        if (neighbour == no_index) {
          ++hull_edges;
        } else {
          const auto& back = flat.neighbours[neighbour];
          CHECK(std::count(back.begin(), back.end(), t) == 1);
        }
      }
    }
    CHECK(flat.triangles.size() == 2 * points.size() - 2 - hull_edges);
    CHECK(area > 0.7);
    CHECK(area < 1);
  }
}

TEST_CASE("no point lies inside the circle of a triangle when nothing is constrained") {
  const std::vector<Vec2> points = scattered(4, 80);
  for (const auto& [a, b, c] : triangulate(points, {}).triangulation.triangles) {
    for (const Vec2& point : points) CHECK(in_circle(points[a], points[b], points[c], point) <= 0);
  }
}

TEST_CASE("constraints are edges of the two triangles beside them") {
  const Constraints constraints = {{0, 2}, {0, 1}};
  const PlanarTriangulation flat = triangulate(square, constraints).triangulation;
  std::array<int, 2> sides = {0, 0};
  for (Index t = 0; t < flat.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index constraint = flat.constraints[t][corner];
      if (constraint == no_index) continue;
      ++sides[constraint];
      std::array<Index, 2> edge = {flat.triangles[t][(corner + 1) % 3], flat.triangles[t][(corner + 2) % 3]};
      std::sort(edge.begin(), edge.end());
      CHECK(edge == constraints[constraint]);
    }
  }
  CHECK(sides == std::array<int, 2>{2, 1});
}

TEST_CASE("what can't be triangulated is told, never repaired") {
  std::vector<Vec2> twice = square;
  twice.push_back(square[1]);
  const PlanarConflict coincident = triangulate(twice, {}).conflict;
  CHECK(coincident.coincident_points == std::vector<std::pair<Index, Index>>{{1, 6}});

  CHECK(triangulate(square, Constraints{{0, 2}, {1, 3}}).conflict.blocked_constraints == std::vector<Index>{1});
  CHECK(triangulate(square, Constraints{{0, 0}}).conflict.blocked_constraints == std::vector<Index>{0});
  std::vector<Vec2> on_line = square;
  on_line.emplace_back(1, 1);
  CHECK(triangulate(on_line, Constraints{{0, 2}}).conflict.blocked_constraints == std::vector<Index>{0});
}

TEST_CASE("too few points and points on one line give no triangles and no conflict") {
  for (const std::vector<Vec2>& points : {std::vector<Vec2>{}, {{1, 1}}, {{0, 0}, {1, 0}}, {{0, 0}, {1, 1}, {3, 3}}}) {
    const PlanarTriangulationResult result = triangulate(points, {});
    CHECK(result.triangulation.triangles.empty());
    CHECK(result.conflict.empty());
  }
}

TEST_CASE("the triangles inside of loops cover what a ray crosses the loops an odd number of times from") {
  const std::vector<Vec2> points = {{0, 0},   {6, 0},   {6, 6},   {3, 4}, {0, 6},  // a notched outline
                                    {1, 1},   {1, 3},   {5, 3},   {5, 1},          // a hole in it, the other way round
                                    {2, 1.5}, {4, 1.5}, {3, 2.5}, {8, 8}};  // an island in the hole; a point outside
  const Constraints loops = {{0, 1}, {1, 2}, {2, 3}, {3, 4},  {4, 0},   {5, 6},
                             {6, 7}, {7, 8}, {8, 5}, {9, 10}, {10, 11}, {11, 9}};
  const PlanarTriangulation plane = triangulate(points, loops).triangulation;
  const auto inside = triangles_inside(plane);
  const auto crossings = [&](const Vec2& place) {
    int count = 0;
    for (const auto& [a, b] : loops) {
      const Vec2 &from = points[a], &to = points[b];
      if ((from.y() > place.y()) == (to.y() > place.y())) continue;
      const double x = from.x() + (place.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
      if (x > place.x()) ++count;
    }
    return count;
  };
  std::vector<std::array<Index, 3>> expected;
  for (const auto& triangle : plane.triangles) {
    const Vec2 middle = (points[triangle[0]] + points[triangle[1]] + points[triangle[2]]) / 3;
    if (crossings(middle) % 2 == 1) expected.push_back(triangle);
  }
  CHECK(inside == expected);
  double area = 0;
  for (const auto& [a, b, c] : inside) area += signed_area(std::array{points[a], points[b], points[c]});
  CHECK(area == Approx(30 - 8 + 1));
}
