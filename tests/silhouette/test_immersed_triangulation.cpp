// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <set>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/immersion.h"
#include "croquis/base/error.h"
#include "croquis/geometry/predicates.h"
#include "silhouette/figure_fixtures.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

/// V - E + F; every edge belongs to one or two triangles.
template <class Triangulation>
int euler_number(const Triangulation& mesh) {
  std::size_t corners = 0;
  std::size_t rims = 0;
  for (const auto& neighbours : mesh.neighbours) {
    corners += 3;
    rims += static_cast<std::size_t>(std::count(neighbours.begin(), neighbours.end(), no_index));
  }
  const std::size_t edges = (corners + rims) / 2;
  return static_cast<int>(mesh.planar_vertex.size()) - static_cast<int>(edges) +
         static_cast<int>(mesh.triangles.size());
}

template <class Triangulation>
double signed_area(const LabelledFigure& figure, const Triangulation& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vec2& a = figure.points[mesh.planar_vertex[triangle[0]]];
    const Vec2& b = figure.points[mesh.planar_vertex[triangle[1]]];
    const Vec2& c = figure.points[mesh.planar_vertex[triangle[2]]];
    sum += cross(b - a, c - a) / 2;
  }
  return sum;
}

/// Every triangle turns left, neighbours agree, and no edge has the point across it inside its triangle's circle.
void check_delaunay(const LabelledFigure& figure, const ImmersedTriangulation& mesh) {
  const auto point = [&](Index vertex) -> const Vec2& { return figure.points[mesh.planar_vertex[vertex]]; };
  int wrong = 0;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    wrong += orientation(point(a), point(b), point(c)) > 0 ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index twin = mesh.neighbours[t][i];
      if (twin == no_index) continue;
      const auto& back = mesh.neighbours[twin];
      const auto j = static_cast<std::size_t>(std::find(back.begin(), back.end(), t) - back.begin());
      REQUIRE(j < 3);
      wrong += mesh.triangles[twin][(j + 1) % 3] == mesh.triangles[t][(i + 2) % 3] ? 0 : 1;
      wrong += mesh.triangles[twin][(j + 2) % 3] == mesh.triangles[t][(i + 1) % 3] ? 0 : 1;
      wrong += in_circle(point(a), point(b), point(c), point(mesh.triangles[twin][j])) > 0 ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
}

/// Boundary edges are the steps along the contours, each once.
void check_rims(const LabelledFigure& figure, const ImmersedTriangulation& mesh) {
  std::multiset<std::pair<Index, Index>> rims;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh.neighbours[t][i] == no_index) {
        rims.insert({mesh.triangles[t][(i + 1) % 3], mesh.triangles[t][(i + 2) % 3]});
      }
    }
  }
  std::multiset<std::pair<Index, Index>> steps;
  for (std::size_t c = 0; c < figure.contours.size(); ++c) {
    const Index first = mesh.first_vertex[c];
    const Index count = mesh.first_vertex[c + 1] - first;
    for (Index i = 0; i < count; ++i) {
      const Index here = first + i;
      const Index there = first + (i + 1) % count;
      steps.insert(figure.contours[c].side > 0 ? std::pair{here, there} : std::pair{there, here});
    }
  }
  CHECK(rims == steps);
}

void check_immersion(const LabelledFigure& figure) {
  Progress progress;
  const LiftedTriangulation lifted = lift(figure);
  const ImmersedTriangulation mesh = immerse(figure, lifted, progress);
  CHECK(static_cast<std::ptrdiff_t>(mesh.planar_vertex.size()) ==
        std::count(lifted.on_boundary.begin(), lifted.on_boundary.end(), 1));
  CHECK(std::set<Index>(mesh.lifted_vertex.begin(), mesh.lifted_vertex.end()).size() == mesh.planar_vertex.size());
  CHECK(euler_number(mesh) == euler_number(lifted));
  CHECK(signed_area(figure, mesh) == Approx(signed_area(figure, lifted)).epsilon(1e-9));
  check_delaunay(figure, mesh);
  check_rims(figure, mesh);
}

}  // namespace

TEST_CASE("the immersed triangulation has the contour points alone and is locally Delaunay") {
  for (const auto& [name, fixture] : test::all_figures()) {
    INFO(name);
    check_immersion(fixture.figure);
  }
}

TEST_CASE("points in line are removed without slivers of no area") {
  // Bars along the axes whose samples lie on common lines; a weave of four.
  const auto bar = [](double x0, double y0, double x1, double y1, Index object) {
    test::FixtureContour contour{{}, 1, object};
    const std::vector<Vec2> corners = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 way = corners[(i + 1) % 4] - corners[i];
      const int count = static_cast<int>(way.norm() / 6);
      for (int k = 0; k < count; ++k) contour.points.push_back(corners[i] + way * k / count);
    }
    return contour;
  };
  // Every line of a bar runs half way between samples of the others.
  const std::vector<test::FixtureContour> bars = {bar(0, 57, 300, 93, 0), bar(0, 177, 300, 213, 1),
                                                  bar(63, 0, 99, 300, 2), bar(183, 0, 219, 300, 3)};
  const std::vector<std::string> names = {"low", "high", "left", "right"};
  const std::vector<std::vector<int>> under = {{2}, {3}, {1}, {0}};  // whom each bar passes below
  const auto depth = [&](Index contour, double position) {
    const auto& points = bars[contour].points;
    const auto i = static_cast<std::size_t>(position);
    const Vec2 at = points[i] + (position - static_cast<double>(i)) * (points[(i + 1) % points.size()] - points[i]);
    const Vec2 low[4] = {{0, 57}, {0, 177}, {63, 0}, {183, 0}};
    const Vec2 high[4] = {{300, 93}, {300, 213}, {99, 300}, {219, 300}};
    int count = 0;
    for (const int other : under[contour]) {
      count += (at.array() > low[other].array()).all() && (at.array() < high[other].array()).all() ? 1 : 0;
    }
    return count;
  };
  check_immersion(test::figure_of_contours(bars, names, 6, depth).figure);
}

TEST_CASE("the immersed triangulation stops when asked to") {
  const auto fixture = test::trefoil_figure();
  const LiftedTriangulation lifted = lift(fixture.figure);
  std::atomic<bool> cancel = true;
  Progress progress({}, &cancel);
  CHECK_THROWS_AS(immerse(fixture.figure, lifted, progress), Cancelled);
}
