// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/sampling/proximity_grid.h"
#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "croquis/base/error.h"
#include "silhouette/figure_fixtures.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

std::vector<test::FigureFixture> fixtures() {
  return {test::disk_figure(),         test::ring_figure(),  test::crossed_capsules_figure(),
          test::figure_eight_figure(), test::snake_figure(), test::trefoil_figure()};
}

double area_of(const std::vector<Vec2>& points, const std::array<Index, 3>& t) {
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) / 2;
}

double region_area(const std::vector<Vec2>& points, const PlanarTriangulation& planar, const std::vector<int>& layers) {
  double sum = 0;
  for (std::size_t t = 0; t < layers.size(); ++t) sum += layers[t] * area_of(points, planar.triangles[t]);
  return sum;
}

}  // namespace

TEST_CASE("counting layers from outside gives the figure's own numbers") {
  for (const test::FigureFixture& fixture : fixtures()) {
    std::vector<RimPiece> pieces;
    for (const DirectedSegment& segment : directed_segments(fixture.figure)) pieces.push_back({segment});
    REQUIRE(pieces.size() == fixture.figure.segments.size());
    for (std::size_t s = 0; s < pieces.size(); ++s) {
      CHECK(fixture.figure.segments[s] == std::array<Index, 2>{pieces[s].begin, pieces[s].end});
    }
    CHECK(count_layers(fixture.figure.triangulation, pieces) == fixture.figure.layers);
    for (RimPiece& piece : pieces) piece.side = -piece.side;
    CHECK_THROWS_AS(count_layers(fixture.figure.triangulation, pieces), Error);
  }
}

TEST_CASE("the sampled region is the figure's region, and every inner edge has an end inside") {
  Progress progress;
  for (const test::FigureFixture& fixture : fixtures()) {
    const LabelledFigure& figure = fixture.figure;
    const Skeleton skeleton = test::skeleton_of(figure);
    const SheetSampling sheets = sample_sheets(figure, skeleton, progress);
    CHECK(region_area(sheets.points, sheets.planar, sheets.layers) ==
          Approx(region_area(figure.points, figure.triangulation, figure.layers)).epsilon(1e-9));
    for (std::size_t p = 0; p < figure.points.size(); ++p) CHECK(sheets.points[p] == figure.points[p]);

    const LiftedTriangulation& lifted = sheets.lifted;
    std::size_t edges = 0;
    int shared_by_rims = 0;
    for (std::size_t m = 0; m < lifted.triangles.size(); ++m) {
      for (std::size_t k = 0; k < 3; ++k) {
        const bool inner = lifted.neighbours[m][k] != no_index;
        edges += inner ? 1 : 2;
        if (inner && lifted.on_boundary[lifted.triangles[m][(k + 1) % 3]] &&
            lifted.on_boundary[lifted.triangles[m][(k + 2) % 3]]) {
          ++shared_by_rims;
        }
      }
    }
    CHECK(shared_by_rims == 0);
    int euler = 0;
    for (const FigureObject& object : figure.objects) euler += object.euler_region;
    CHECK(static_cast<int>(lifted.planar_vertex.size() + lifted.triangles.size()) - static_cast<int>(edges / 2) ==
          euler);
  }
}

TEST_CASE("distances from the rim are those of the own sheet") {
  Progress progress;
  for (const test::FigureFixture& fixture : fixtures()) {
    const Skeleton skeleton = test::skeleton_of(fixture.figure);
    const SheetSampling sheets = sample_sheets(fixture.figure, skeleton, progress);
    const RimDistances rim = rim_distances(sheets, 0.5);
    const auto place = [&](Index v) { return sheets.points[sheets.lifted.planar_vertex[v]]; };
    std::size_t reached = 0;
    for (Index v = 0; v < rim.nearest.size(); ++v) {
      CHECK((rim.distance[v] == 0) == (sheets.lifted.on_boundary[v] != 0));
      if (rim.nearest[v] == no_index || rim.distance[v] == 0) continue;
      ++reached;
      const RimEdge& edge = rim.edges[rim.nearest[v]];
      CHECK(rim.distance[v] <= 0.5 * edge.radius);
      CHECK(depth_below(sheets, edge, v) > 0);
      CHECK(depth_below(sheets, edge, v) <= rim.distance[v] + 1e-9);
      for (const Index end : {edge.begin, edge.end}) {
        CHECK((place(end) - place(v)).norm() >= rim.distance[v] - 1e-9);
      }
    }
    CHECK(reached > rim.nearest.size() / 4);
  }
  // A disk has one rim only, so that every distance is known.
  const test::FigureFixture disk = test::disk_figure();
  const Skeleton skeleton = test::skeleton_of(disk.figure);
  const SheetSampling sheets = sample_sheets(disk.figure, skeleton, progress);
  const RimDistances rim = rim_distances(sheets, 0.5);
  for (Index v = 0; v < rim.nearest.size(); ++v) {
    const double depth = 100 - sheets.points[sheets.lifted.planar_vertex[v]].norm();
    if (depth < 49) CHECK(rim.distance[v] == Approx(depth).margin(0.2));
    if (depth > 51) CHECK(rim.nearest[v] == no_index);
  }
}

TEST_CASE("no edge runs from a rim past its first row") {
  Progress progress;
  for (const test::FigureFixture& fixture : fixtures()) {
    const Skeleton skeleton = test::skeleton_of(fixture.figure);
    const SheetSampling sheets = sample_sheets(fixture.figure, skeleton, progress);
    const RimDistances rim = rim_distances(sheets, 0.5);
    const auto& lifted = sheets.lifted;
    int past = 0;
    for (const auto& t : lifted.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!lifted.on_boundary[t[k]] || lifted.on_boundary[t[(k + 1) % 3]]) continue;
        const RimEdge& edge = rim.edges[rim.nearest[t[k]]];
        past += depth_below(sheets, edge, t[(k + 1) % 3]) > 0.1 * edge.radius ? 1 : 0;
      }
    }
    CHECK(past == 0);
  }
}

TEST_CASE("nodes are found where they are, in their own layer") {
  Progress progress;
  for (const test::FigureFixture& fixture : fixtures()) {
    const Skeleton skeleton = test::skeleton_of(fixture.figure);
    const SheetSampling sheets = sample_sheets(fixture.figure, skeleton, progress);
    const std::vector<LiftedPlace> places = locate_nodes(fixture.figure, skeleton, sheets);
    REQUIRE(places.size() == skeleton.nodes.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
      Vec2 found = Vec2::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        found += places[n].weights[k] * sheets.points[sheets.lifted.planar_vertex[places[n].vertices[k]]];
      }
      CHECK((found - skeleton.nodes[n].position).norm() < 1e-9 * skeleton.scale);
    }
  }
}

TEST_CASE("walking finds the triangle of any place") {
  const test::FigureFixture fixture = test::trefoil_figure();
  const std::vector<Vec2>& points = fixture.figure.points;
  PlanarWalk walk(points, fixture.figure.triangulation);
  Vec2 low = points.front(), high = low;
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  test::Random random(5);
  for (int k = 0; k < 500; ++k) {
    const Vec2 place(random.between(low.x() - 20, high.x() + 20), random.between(low.y() - 20, high.y() + 20));
    const auto holds = [&](const std::array<Index, 3>& t) {
      return area_of({points[t[0]], points[t[1]], place}, {0, 1, 2}) >= 0 &&
             area_of({points[t[1]], points[t[2]], place}, {0, 1, 2}) >= 0 &&
             area_of({points[t[2]], points[t[0]], place}, {0, 1, 2}) >= 0;
    };
    const Index found = walk.locate(place);
    const auto& all = fixture.figure.triangulation.triangles;
    if (found == no_index) {
      CHECK(std::none_of(all.begin(), all.end(), holds));
    } else {
      CHECK(holds(all[found]));
    }
  }
}

TEST_CASE("the grid agrees with measuring every distance") {
  test::Random random(9);
  ProximityGrid grid(4);
  std::vector<std::array<Vec2, 2>> items;
  for (int k = 0; k < 60; ++k) {
    const Vec2 a(random.between(0, 100), random.between(0, 60));
    const Vec2 b = k % 3 == 0 ? a : Vec2(a + Vec2(random.between(-15, 15), random.between(-15, 15)));
    items.push_back({a, b});
    grid.add(a, b);
  }
  for (int k = 0; k < 2000; ++k) {
    const Vec2 place(random.between(0, 100), random.between(0, 60));
    const double distance = random.between(0, 4);
    bool near = false;
    for (const auto& [a, b] : items) {
      double least = (place - a).norm();
      for (int s = 0; s <= 400; ++s) least = std::min(least, (a + s / 400.0 * (b - a) - place).norm());
      if (std::abs(least - distance) < 0.05) least = grid.any_within(place, distance) ? 0 : 1e9;  // too close to call
      near = near || least < distance;
    }
    CHECK(grid.any_within(place, distance) == near);
  }
}
