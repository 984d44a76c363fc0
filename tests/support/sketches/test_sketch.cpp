// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::test;

namespace {

struct Row {
  const char* name;
  Sketch sketch;
  int strokes, contours, crossings, arcs, hidden;
  std::vector<int> depths;
  int panels, components, euler_region, euler_mesh;
};

int sum(const std::vector<int>& values) { return std::accumulate(values.begin(), values.end(), 0); }

/// Crossings of closed polylines counted by brute force with a test of its own: the sign of a product of areas.
int crossings_by_pairs(const std::vector<TrueContour>& contours) {
  struct Piece {
    Vec2 a, b;
    std::size_t contour, index, size;
  };
  std::vector<Piece> pieces;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto& points = contours[c].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      pieces.push_back({points[i], points[(i + 1) % points.size()], c, i, points.size()});
    }
  }
  const auto area = [](const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); };
  int count = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = i + 1; k < pieces.size(); ++k) {
      const Piece& p = pieces[i];
      const Piece& q = pieces[k];
      const bool neighbours = p.contour == q.contour && (k - i == 1 || k - i == p.size - 1);
      if (neighbours) continue;
      if (area(p.a, p.b, q.a) * area(p.a, p.b, q.b) < 0 && area(q.a, q.b, p.a) * area(q.a, q.b, p.b) < 0) ++count;
    }
  }
  return count;
}

double distance_to_drawn(const Drawing& drawing, const Stroke& own, const Vec2& place) {
  double nearest = 1e300;
  for (const Stroke& stroke : drawing.strokes) {
    const std::size_t n = stroke.samples.size();
    for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < n; ++i) {
      const bool own_end = &stroke == &own && (i < 5 || i + 6 > n);
      if (own_end) continue;
      const Vec2 a = stroke.samples[i].position;
      const Vec2 d = stroke.samples[(i + 1) % n].position - a;
      const double t = std::clamp((place - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (a + t * d - place).norm());
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("generated sketches have the published counts") {
  const std::vector<Row> rows = {
      {"circle", circle_sketch(), 1, 1, 0, 1, 0, {1}, 1, 1, 1, 2},
      {"annulus", annulus_sketch(), 2, 2, 0, 2, 0, {2}, 1, 1, 0, 0},
      {"trefoil", trefoil_sketch(), 6, 2, 12, 24, 6, {18, 6}, 12, 1, 0, 0},
      {"knot 2,5", torus_knot_sketch(2, 5), 10, 2, 20, 40, 10, {30, 10}, 20, 1, 0, 0},
      {"knot 3,4", torus_knot_sketch(3, 4), 16, 2, 32, 64, 16, {48, 16}, 32, 1, 0, 0},
      {"snake", snake_sketch(), 2, 1, 4, 8, 2, {6, 2}, 5, 1, 1, 2},
      {"ring and bar", ring_and_bar_sketch(), 4, 3, 8, 16, 4, {12, 4}, 9, 2, 1, 2},
      {"three blobs", three_blobs_sketch(), 4, 3, 6, 12, 3, {9, 3}, 9, 3, 3, 6},
      {"chain", chain_sketch(5), 16, 10, 32, 64, 16, {48, 16}, 32, 5, 0, 0},
      {"linked rings", linked_rings_sketch(), 4, 4, 8, 16, 4, {12, 4}, 8, 2, 0, 0},
      {"borromean", borromean_sketch(), 12, 6, 24, 48, 12, {36, 12}, 24, 3, 0, 0},
      {"figure eight", figure_eight_sketch(), 2, 2, 4, 8, 2, {6, 2}, 4, 1, 0, 0},
      {"weave", weave_sketch(4, 4), 32, 8, 64, 128, 32, {96, 32}, 72, 8, 8, 16},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const SketchTruth& truth = row.sketch.truth;
    CHECK(truth.strokes == row.strokes);
    CHECK(truth.contours == row.contours);
    CHECK(truth.crossings == row.crossings);
    CHECK(truth.arcs == row.arcs);
    CHECK(truth.hidden_arcs == row.hidden);
    CHECK(truth.depth_histogram == row.depths);
    CHECK(truth.panels == row.panels);
    CHECK(truth.components == row.components);
    CHECK(sum(truth.euler_region) == row.euler_region);
    CHECK(sum(truth.euler_mesh) == row.euler_mesh);
  }
}

TEST_CASE("crossings of every sketch agree with a count over all pairs of segments") {
  for (const auto& [name, sketch] : all_sketches()) {
    INFO(name);
    CHECK(sketch.truth.crossings == crossings_by_pairs(sketch.truth.outlines));
  }
}

TEST_CASE("every open end lies on a drawn line, and every stroke shows") {
  for (const auto& [name, sketch] : all_sketches()) {
    INFO(name);
    REQUIRE(static_cast<int>(sketch.drawing.strokes.size()) == sketch.truth.strokes);
    for (const Stroke& stroke : sketch.drawing.strokes) {
      INFO(stroke.id);
      CHECK(stroke.samples.size() >= 4);
      if (stroke.closed) continue;
      CHECK(distance_to_drawn(sketch.drawing, stroke, stroke.samples.front().position) < 1e-9);
      CHECK(distance_to_drawn(sketch.drawing, stroke, stroke.samples.back().position) < 1e-9);
    }
  }
}

TEST_CASE("the animals have nothing hidden twice") {
  for (const Sketch& sketch : {dog_sketch(), duck_sketch(), octopus_sketch()}) {
    CHECK(sketch.truth.strokes >= 8);
    CHECK(sketch.truth.depth_histogram.size() == 2);
    CHECK(sketch.truth.arcs == 2 * sketch.truth.crossings);
    CHECK(diagonal(sketch.drawing) > 700);
    CHECK(diagonal(sketch.drawing) < 1150);
  }
}

TEST_CASE("random sketches keep their promises for many seeds") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    INFO(seed);
    const Sketch tube = random_tube_sketch(seed);
    CHECK(tube.truth.crossings % 4 == 0);
    CHECK(tube.truth.hidden_arcs * 2 == tube.truth.crossings);
    CHECK(tube.truth.strokes == tube.truth.hidden_arcs);
    CHECK(tube.truth.panels == tube.truth.crossings);
    const int parts = 2 + static_cast<int>(seed % 6);
    const Sketch layers = random_layered_sketch(seed, parts);
    CHECK(layers.truth.components == parts);
    CHECK(layers.truth.crossings == crossings_by_pairs(layers.truth.outlines));
    CHECK(layers.truth.arcs == 2 * layers.truth.crossings);
  }
}

TEST_CASE("panels agree with the layers counted over a grid for the areas they cover") {
  // Sum of layers times area equals the area inside all contours, counted with sign.
  for (const auto& [name, sketch] : all_sketches()) {
    INFO(name);
    double exact = 0;
    for (const TrueContour& contour : sketch.truth.outlines) {
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        exact += cross(contour.points[i], contour.points[(i + 1) % contour.points.size()]) / 2;
      }
    }
    double counted = 0;
    for (double x = -50; x < 1000; x += 6.1) {
      for (double y = -50; y < 800; y += 6.1) counted += 6.1 * 6.1 * layers_at(sketch.truth, {x + 3.3, y + 4.7});
    }
    CHECK(counted == Approx(exact).epsilon(0.03));
  }
}

TEST_CASE("error sketches name strokes that exist") {
  const std::vector<ErrorSketch> sketches = error_sketches();
  CHECK(sketches.size() == 7);
  for (const ErrorSketch& sketch : sketches) {
    INFO(sketch.code);
    for (const std::string& id : sketch.strokes) {
      CHECK(std::any_of(sketch.drawing.strokes.begin(), sketch.drawing.strokes.end(),
                        [&](const Stroke& stroke) { return stroke.id == id; }));
    }
  }
}
