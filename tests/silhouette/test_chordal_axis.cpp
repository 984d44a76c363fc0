// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "croquis/geometry/predicates.h"
#include "silhouette/figure_fixtures.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

Skeleton skeleton_of(const LabelledFigure& figure, double node_spacing = 0.3) {
  Progress progress;
  return chordal_axis(figure, node_spacing, progress);
}

struct Shape {
  int components = 0;
  int ends = 0;
  int junctions = 0;
  int loops = 0;  ///< E - V + components
};

Shape shape_of(const Skeleton& skeleton) {
  std::vector<std::size_t> label(skeleton.nodes.size());
  std::iota(label.begin(), label.end(), std::size_t{0});
  std::vector<int> degree(skeleton.nodes.size(), 0);
  for (const auto& [a, b] : skeleton.edges) {
    ++degree[a];
    ++degree[b];
    std::replace(label.begin(), label.end(), std::size_t{label[a]}, std::size_t{label[b]});
  }
  Shape shape;
  shape.components = static_cast<int>(std::set<std::size_t>(label.begin(), label.end()).size());
  shape.ends = static_cast<int>(std::count(degree.begin(), degree.end(), 1));
  shape.junctions = static_cast<int>(std::count_if(degree.begin(), degree.end(), [](int d) { return d > 2; }));
  shape.loops = static_cast<int>(skeleton.edges.size()) - static_cast<int>(skeleton.nodes.size()) + shape.components;
  return shape;
}

bool contains(const LabelledFigure& figure, Index triangle, const Vec2& place, double slack) {
  const auto& corners = figure.triangulation.triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& a = figure.points[corners[i]];
    const Vec2& b = figure.points[corners[(i + 1) % 3]];
    if (cross(b - a, place - a) < -slack * (b - a).norm()) return false;
  }
  return true;
}

/// Panels of a chord, its node's place and lengths fit together.
void check_nodes(const LabelledFigure& figure, const Skeleton& skeleton) {
  for (const SkeletonNode& node : skeleton.nodes) {
    REQUIRE(node.place.triangle < figure.layers.size());
    CHECK(static_cast<int>(node.place.layer) < figure.layers[node.place.triangle]);
    CHECK(contains(figure, node.place.triangle, node.position, 1e-9));
    CHECK(node.radius > 0);
    REQUIRE(node.parts.size() == node.crossed.size());
    std::set<std::pair<Index, Index>> panels;
    bool own = false;
    for (const SheetPlace& place : node.crossed) {
      CHECK(panels.insert({figure.faces[place.triangle], place.layer}).second);
      own =
          own || (figure.faces[place.triangle] == figure.faces[node.place.triangle] && place.layer == node.place.layer);
    }
    CHECK(own);
  }
}

/// Every contour point has a radius; on a tube it is the tube's.
void check_contour_radius(const LabelledFigure& figure, const Skeleton& skeleton, double radius, double tolerance) {
  REQUIRE(skeleton.contour_radius.size() == figure.contours.size());
  for (std::size_t c = 0; c < figure.contours.size(); ++c) {
    REQUIRE(skeleton.contour_radius[c].size() == figure.contours[c].vertices.size());
    for (const double r : skeleton.contour_radius[c]) CHECK(std::abs(r - radius) < tolerance * radius);
  }
}

}  // namespace

TEST_CASE("a disk has one node, in its middle") {
  const auto fixture = test::disk_figure();
  const Skeleton skeleton = skeleton_of(fixture.figure);
  REQUIRE(skeleton.nodes.size() == 1);
  CHECK(skeleton.edges.empty());
  CHECK(skeleton.nodes[0].position.norm() < 1);
  CHECK(skeleton.nodes[0].radius == Approx(100).epsilon(0.01));
  CHECK(skeleton.scale == skeleton.nodes[0].radius);
  check_nodes(fixture.figure, skeleton);
  check_contour_radius(fixture.figure, skeleton, 100, 0.01);
}

TEST_CASE("a ring has one loop along its middle") {
  const auto fixture = test::ring_figure();
  const Skeleton skeleton = skeleton_of(fixture.figure);
  const Shape shape = shape_of(skeleton);
  CHECK(shape.components == 1);
  CHECK(shape.ends == 0);
  CHECK(shape.junctions == 0);
  CHECK(shape.loops == 1);
  for (const SkeletonNode& node : skeleton.nodes) CHECK(node.position.norm() == Approx(100).epsilon(0.02));
  CHECK(skeleton.scale == Approx(20).epsilon(0.05));
  check_nodes(fixture.figure, skeleton);
  check_contour_radius(fixture.figure, skeleton, 20, 0.1);
}

TEST_CASE("a capsule has one path between the centres of its ends") {
  const auto fixture = test::capsule_figure();
  const Skeleton skeleton = skeleton_of(fixture.figure);
  const Shape shape = shape_of(skeleton);
  CHECK(shape.components == 1);
  CHECK(shape.ends == 2);
  CHECK(shape.junctions == 0);
  CHECK(shape.loops == 0);
  double low = 1e9;
  double high = -1e9;
  for (const SkeletonNode& node : skeleton.nodes) {
    CHECK(std::abs(node.position.y()) < 1);
    CHECK(node.radius == Approx(40).epsilon(0.03));
    low = std::min(low, node.position.x());
    high = std::max(high, node.position.x());
  }
  CHECK(low == Approx(0).margin(8));
  CHECK(high == Approx(220).margin(8));
  check_nodes(fixture.figure, skeleton);
  check_contour_radius(fixture.figure, skeleton, 40, 0.05);
}

TEST_CASE("crossing tubes keep axes of their own") {
  struct Row {
    const char* name;
    test::FigureFixture fixture;
    int components, ends, loops;
  };
  const std::vector<Row> rows = {{"crossed capsules", test::crossed_capsules_figure(), 2, 4, 0},
                                 {"figure eight", test::figure_eight_figure(), 1, 0, 1},
                                 {"snake", test::snake_figure(), 1, 2, 0},
                                 {"linked rings", test::linked_rings_figure(), 2, 0, 2},
                                 {"trefoil", test::trefoil_figure(), 1, 0, 1}};
  for (const Row& row : rows) {
    INFO(row.name);
    const Skeleton skeleton = skeleton_of(row.fixture.figure);
    const Shape shape = shape_of(skeleton);
    CHECK(shape.components == row.components);
    CHECK(shape.ends == row.ends);
    CHECK(shape.loops == row.loops);
    CHECK(shape.junctions == 0);
    check_nodes(row.fixture.figure, skeleton);
    for (const auto& [a, b] : skeleton.edges) CHECK(skeleton.nodes[a].object == skeleton.nodes[b].object);
  }
}

TEST_CASE("the trefoil's loop has a node every 0.3 radii and passes all twelve panels") {
  const auto fixture = test::trefoil_figure();
  const Skeleton skeleton = skeleton_of(fixture.figure);
  double length = 0;
  for (const auto& [a, b] : skeleton.edges) {
    length += (skeleton.nodes[b].position - skeleton.nodes[a].position).norm();
  }
  CHECK(length / static_cast<double>(skeleton.nodes.size()) == Approx(0.3 * 36).epsilon(0.05));
  CHECK(skeleton.edges.size() == skeleton.nodes.size());
  std::set<std::pair<Index, Index>> panels;
  for (const SkeletonNode& node : skeleton.nodes) {
    for (const SheetPlace& place : node.crossed) panels.insert({fixture.figure.faces[place.triangle], place.layer});
  }
  CHECK(panels.size() == 12);
  check_contour_radius(fixture.figure, skeleton, 36, 0.1);
}

TEST_CASE("a finer spacing gives proportionally more nodes on the same line") {
  const auto fixture = test::trefoil_figure();
  const auto coarse = skeleton_of(fixture.figure, 0.6);
  const auto fine = skeleton_of(fixture.figure, 0.2);
  CHECK(static_cast<double>(fine.nodes.size()) / static_cast<double>(coarse.nodes.size()) == Approx(3).epsilon(0.15));
}

TEST_CASE("three arms meet in one junction") {
  // A three-armed star with round ends: offsets of three rays from the centre.
  test::FixtureContour contour;
  const double arm = 200;
  const double half = 30;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * 3.14159265358979 * k / 3 + 0.1;
    const Vec2 out(std::cos(angle), std::sin(angle));
    const Vec2 left = left_of(out);
    const double armpit = half / std::tan(3.14159265358979 / 3);
    const auto side = [&](double sign, bool outwards) {
      for (int i = 0; i < 30; ++i) {
        const double t = (outwards ? i + 1 : 30 - i) / 31.0;
        contour.points.push_back(out * (armpit + t * (arm - armpit)) + sign * half * left);
      }
    };
    contour.points.push_back(out * armpit - half * left);
    side(-1, true);
    for (int i = 0; i <= 16; ++i) {
      const double turn = 3.14159265358979 * (i / 16.0 - 0.5);
      contour.points.push_back(out * (arm + half * std::cos(turn)) + left * half * std::sin(turn));
    }
    side(1, false);
  }
  const std::vector<std::string> names = {"star"};
  const auto fixture = test::figure_of_contours(std::vector{contour}, names, 6, [](Index, double) { return 0; });
  const Skeleton skeleton = skeleton_of(fixture.figure);
  const Shape shape = shape_of(skeleton);
  CHECK(shape.components == 1);
  CHECK(shape.ends == 3);
  CHECK(shape.junctions == 1);
  CHECK(shape.loops == 0);
  check_nodes(fixture.figure, skeleton);
}

TEST_CASE("the skeleton of every sample sketch has the loops and pieces of its solids") {
  for (const auto& [name, sketch] : test::sketches_with_random_ones(12)) {
    INFO(name);
    Progress progress;
    const LabelledDrawing labelled = label(sketch.drawing, {}, progress);
    int components = 0;
    int loops = 0;
    for (const LabelledFigure& figure : labelled.figures) {
      const Skeleton skeleton = skeleton_of(figure);
      const Shape shape = shape_of(skeleton);
      components += shape.components;
      loops += shape.loops;
      check_nodes(figure, skeleton);
      for (const auto& contour : skeleton.contour_radius) {
        CHECK(std::all_of(contour.begin(), contour.end(), [](double radius) { return radius > 0; }));
      }
    }
    const std::vector<int>& euler = sketch.truth.euler_region;
    CHECK(components == sketch.truth.components);
    CHECK(components - loops == std::accumulate(euler.begin(), euler.end(), 0));
  }
}

TEST_CASE("the skeleton's shape survives a noisy hand") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    const Drawing drawing = test::noisy(test::trefoil_sketch().drawing, seed);
    Progress progress;
    const LabelledDrawing labelled = label(drawing, Options::of(Preset::Tablet), progress);
    REQUIRE(labelled.figures.size() == 1);
    const Shape shape = shape_of(skeleton_of(labelled.figures[0]));
    CHECK(shape.components == 1);
    CHECK(shape.loops == 1);
    CHECK(shape.ends == 0);
  }
}
