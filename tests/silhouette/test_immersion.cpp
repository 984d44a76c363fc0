// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/immersion.h"
#include "croquis/base/error.h"
#include "silhouette/figure_fixtures.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

/// Two squares of side 2, one shifted by (1,1); they cross at points 8 and 9.
struct CrossedSquares {
  std::vector<Vec2> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {2, 1}, {1, 2}};
  std::vector<std::array<Index, 2>> segments = {{0, 1}, {1, 8}, {8, 2}, {2, 9}, {9, 3}, {3, 0},
                                                {4, 8}, {8, 5}, {5, 6}, {6, 7}, {7, 9}, {9, 4}};
  PlanarTriangulation planar = triangulate(points, segments).triangulation;
  std::vector<int> layers;

  CrossedSquares() {
    for (const auto& triangle : planar.triangles) {
      const Vec2 middle = (points[triangle[0]] + points[triangle[1]] + points[triangle[2]]) / 3;
      layers.push_back(inside(middle, 0) + inside(middle, 1));
    }
  }

  static int inside(const Vec2& point, double low) {
    return point.x() > low && point.x() < low + 2 && point.y() > low && point.y() < low + 2 ? 1 : 0;
  }

  /// Depths with the first (second) square's corner hidden below the other one by that many layers.
  static std::vector<int> depths(int first, int second) {
    return {0, 0, first, first, 0, 0, second, 0, 0, 0, 0, second};
  }
};

int euler_number(const LiftedTriangulation& lifted) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& triangle : lifted.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
  }
  return static_cast<int>(lifted.planar_vertex.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(lifted.triangles.size());
}

/// Lengths of the boundary loops, shortest first.
std::multiset<int> boundary_loops(const LiftedTriangulation& lifted) {
  std::map<Index, Index> following;
  for (std::size_t m = 0; m < lifted.triangles.size(); ++m) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (lifted.neighbours[m][i] != no_index) continue;
      const Index start = lifted.triangles[m][(i + 1) % 3];
      REQUIRE(following.count(start) == 0);
      following[start] = lifted.triangles[m][(i + 2) % 3];
    }
  }
  std::multiset<int> lengths;
  while (!following.empty()) {
    int length = 0;
    for (auto at = following.begin(); at != following.end(); ++length) {
      const Index to = at->second;
      following.erase(at);
      at = following.find(to);
    }
    lengths.insert(length);
  }
  return lengths;
}

void check_gluing(const PlanarTriangulation& planar, const LiftedTriangulation& lifted) {
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    CHECK(lifted.layer_of(m) < lifted.first_copy[lifted.planar_triangle[m] + 1]);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(lifted.planar_vertex[lifted.triangles[m][i]] == planar.triangles[lifted.planar_triangle[m]][i]);
      const Index twin = lifted.neighbours[m][i];
      if (twin == no_index) continue;
      const auto& back = lifted.neighbours[twin];
      const auto j = static_cast<std::size_t>(std::find(back.begin(), back.end(), m) - back.begin());
      REQUIRE(j < 3);
      CHECK(lifted.triangles[m][(i + 1) % 3] == lifted.triangles[twin][(j + 2) % 3]);
      CHECK(lifted.triangles[m][(i + 2) % 3] == lifted.triangles[twin][(j + 1) % 3]);
    }
  }
}

void check_internal_error(const PlanarTriangulation& planar, std::span<const int> layers, std::span<const int> depths) {
  try {
    lift(planar, layers, depths);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.findings().front().code == "E_INTERNAL");
  }
}

}  // namespace

TEST_CASE("two overlapping squares lift to two separate disks whichever is in front") {
  const CrossedSquares squares;
  const bool first_in_front = GENERATE(true, false);
  const auto depths = first_in_front ? CrossedSquares::depths(0, 1) : CrossedSquares::depths(1, 0);
  const LiftedTriangulation lifted = lift(squares.planar, squares.layers, depths);

  check_gluing(squares.planar, lifted);
  CHECK(lifted.triangles.size() ==
        static_cast<std::size_t>(std::count(squares.layers.begin(), squares.layers.end(), 1) +
                                 2 * std::count(squares.layers.begin(), squares.layers.end(), 2)));
  CHECK(euler_number(lifted) == 2);
  CHECK(boundary_loops(lifted) == std::multiset<int>{6, 6});
  // Only the corner of the other square, covered or covering, lies inside a sheet.
  CHECK(std::count(lifted.on_boundary.begin(), lifted.on_boundary.end(), 0) == 2);

  // The corner (1,1) belongs to the second square; above or below it runs the first one.
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = lifted.triangles[m][i];
      if (lifted.planar_vertex[vertex] != 4 || !lifted.on_boundary[vertex]) continue;
      CHECK(lifted.layer_of(m) == (first_in_front ? 1U : 0U));
    }
  }
}

TEST_CASE("a square with a square hole lifts to an annulus") {
  const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const std::vector<std::array<Index, 2>> segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const PlanarTriangulation planar = triangulate(points, segments).triangulation;
  std::vector<int> layers;
  for (const auto& triangle : planar.triangles) {
    layers.push_back(std::all_of(triangle.begin(), triangle.end(), [](Index v) { return v >= 4; }) ? 0 : 1);
  }
  const LiftedTriangulation lifted = lift(planar, layers, std::vector<int>(segments.size(), 0));
  check_gluing(planar, lifted);
  CHECK(euler_number(lifted) == 0);
  CHECK(boundary_loops(lifted) == std::multiset<int>{4, 4});
  CHECK(lifted.triangles.size() == 8);
}

TEST_CASE("the sheets of labelled tubes are bounded by the contours and have the tubes' Euler numbers") {
  struct Row {
    std::size_t contours, crossings, hidden_arcs;
    int panels, euler;
  };
  const std::map<std::string, Row> rows = {{"disk", {1, 0, 0, 1, 1}},         {"ring", {2, 0, 0, 1, 0}},
                                           {"capsule", {1, 0, 0, 1, 1}},      {"crossed capsules", {2, 4, 2, 6, 2}},
                                           {"figure eight", {2, 4, 2, 4, 0}}, {"snake", {1, 4, 2, 5, 1}},
                                           {"linked rings", {4, 8, 4, 8, 0}}, {"trefoil", {2, 12, 6, 12, 0}}};
  for (const auto& [name, fixture] : test::all_figures()) {
    INFO(name);
    const Row& row = rows.at(name);
    const LabelledFigure& figure = fixture.figure;
    CHECK(figure.contours.size() == row.contours);
    CHECK(figure.crossings.size() == row.crossings);
    if (row.crossings > 0) CHECK(figure.arcs.size() == 2 * row.crossings);
    CHECK(static_cast<std::size_t>(std::count_if(figure.arcs.begin(), figure.arcs.end(), [](const FigureArc& arc) {
            return arc.depth == 1 && !arc.visible;
          })) == row.hidden_arcs);
    CHECK(figure.panels == row.panels);

    const LiftedTriangulation lifted = lift(figure);
    check_gluing(figure.triangulation, lifted);
    CHECK(euler_number(lifted) == row.euler);
    std::multiset<int> lengths;
    for (const FigureContour& contour : figure.contours) lengths.insert(static_cast<int>(contour.vertices.size()));
    CHECK(boundary_loops(lifted) == lengths);

    const auto rims = contour_vertices(figure, lifted);
    for (std::size_t c = 0; c < rims.size(); ++c) {
      REQUIRE(rims[c].size() == figure.contours[c].vertices.size());
      for (std::size_t i = 0; i < rims[c].size(); ++i) {
        CHECK(lifted.on_boundary[rims[c][i]] == 1);
        CHECK(lifted.planar_vertex[rims[c][i]] == figure.contours[c].vertices[i]);
      }
    }
  }
}

TEST_CASE("contours that swap sheets at a crossing are refused") {
  // Two squares of which each hides a corner of the other: the sheets close, but their rims turn off at the crossings.
  const std::vector<test::FixtureContour> squares = {{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1, 0},
                                                     {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, 1, 1}};
  const std::vector<std::string> names = {"first", "second"};
  const auto hidden_corner = [](Index contour, double position) {
    return contour == 0 ? (position > 1.5 && position < 2.5 ? 1 : 0) : (position < 0.5 || position > 3.5 ? 1 : 0);
  };
  const auto fixture = test::figure_of_contours(squares, names, 1, hidden_corner);
  const LiftedTriangulation lifted = lift(fixture.figure);
  CHECK_THROWS_AS(contour_vertices(fixture.figure, lifted), Error);
}

TEST_CASE("a contour that dives through a sheet between two crossings is refused") {
  const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const std::vector<std::array<Index, 2>> segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const PlanarTriangulation planar = triangulate(points, segments).triangulation;
  std::vector<int> layers;
  for (const auto& triangle : planar.triangles) {
    layers.push_back(std::all_of(triangle.begin(), triangle.end(), [](Index v) { return v >= 4; }) ? 2 : 1);
  }
  CHECK_NOTHROW(lift(planar, layers, std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  check_internal_error(planar, layers, std::vector<int>{0, 0, 0, 0, 0, 0, 1, 1});
}

TEST_CASE("a constraint of negative depth is glued like a plain edge") {
  const std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<std::array<Index, 2>> segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
  const PlanarTriangulation planar = triangulate(points, segments).triangulation;
  const LiftedTriangulation lifted = lift(planar, std::vector<int>{1, 1}, std::vector<int>{0, 0, 0, 0, -1});
  CHECK(lifted.planar_vertex.size() == 4);
  CHECK(boundary_loops(lifted) == std::multiset<int>{4});
}

TEST_CASE("labels that the layers contradict are refused") {
  const CrossedSquares squares;
  SECTION("a piece is hidden below more surfaces than there are") {
    check_internal_error(squares.planar, squares.layers, CrossedSquares::depths(2, 0));
  }
  SECTION("the layers change across a plain edge") {
    std::vector<int> layers = squares.layers;
    for (int& count : layers) {
      if (count == 2) {
        count = 3;
        break;
      }
    }
    check_internal_error(squares.planar, layers, CrossedSquares::depths(1, 0));
  }
  SECTION("a depth is missing") { check_internal_error(squares.planar, squares.layers, std::vector<int>(4, 0)); }
}
