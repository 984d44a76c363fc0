// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/geometry/predicates.h"
#include "silhouette/figure_fixtures.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::skeleton_of;

namespace {

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

TEST_CASE("tubes have axes of their own: paths between their ends, loops, and one node for a disk") {
  struct Row {
    int components, ends, loops;
  };
  const std::map<std::string, Row> rows = {
      {"disk", {1, 0, 0}},         {"ring", {1, 0, 1}},  {"capsule", {1, 2, 0}},      {"crossed capsules", {2, 4, 0}},
      {"figure eight", {1, 0, 1}}, {"snake", {1, 2, 0}}, {"linked rings", {2, 0, 2}}, {"trefoil", {1, 0, 1}}};
  for (const auto& [name, fixture] : test::all_figures()) {
    INFO(name);
    const Skeleton skeleton = skeleton_of(fixture.figure);
    const Shape shape = shape_of(skeleton);
    CHECK(shape.components == rows.at(name).components);
    CHECK(shape.ends == rows.at(name).ends);
    CHECK(shape.loops == rows.at(name).loops);
    CHECK(shape.junctions == 0);
    check_nodes(fixture.figure, skeleton);
    for (const auto& [a, b] : skeleton.edges) CHECK(skeleton.nodes[a].object == skeleton.nodes[b].object);
  }
}

TEST_CASE("nodes lie in the middle, with the radius of the tube") {
  const auto disk = test::disk_figure(), ring = test::ring_figure(), capsule = test::capsule_figure();
  const Skeleton one = skeleton_of(disk.figure);
  REQUIRE(one.nodes.size() == 1);
  CHECK(one.nodes[0].position.norm() < 1);
  CHECK(one.nodes[0].radius == Approx(100).epsilon(0.01));
  CHECK(one.scale == one.nodes[0].radius);
  check_contour_radius(disk.figure, one, 100, 0.01);
  const Skeleton loop = skeleton_of(ring.figure);
  for (const SkeletonNode& node : loop.nodes) CHECK(node.position.norm() == Approx(100).epsilon(0.02));
  CHECK(loop.scale == Approx(20).epsilon(0.05));
  check_contour_radius(ring.figure, loop, 20, 0.1);
  const Skeleton path = skeleton_of(capsule.figure);
  double low = 1e9, high = -1e9;
  for (const SkeletonNode& node : path.nodes) {
    CHECK(std::abs(node.position.y()) < 1);
    CHECK(node.radius == Approx(40).epsilon(0.03));
    low = std::min(low, node.position.x());
    high = std::max(high, node.position.x());
  }
  CHECK(low == Approx(0).margin(8));
  CHECK(high == Approx(220).margin(8));
  check_contour_radius(capsule.figure, path, 40, 0.05);
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
  std::vector<Vec2> outline;
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
        outline.push_back(out * (armpit + t * (arm - armpit)) + sign * half * left);
      }
    };
    outline.push_back(out * armpit - half * left);
    side(-1, true);
    for (int i = 0; i <= 16; ++i) {
      const double turn = 3.14159265358979 * (i / 16.0 - 0.5);
      outline.push_back(out * (arm + half * std::cos(turn)) + left * half * std::sin(turn));
    }
    side(1, false);
  }
  const auto fixture = test::figure_of_outline("star", outline, 6);
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
