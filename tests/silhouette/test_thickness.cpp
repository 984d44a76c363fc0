// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/surface/thickness.h"
#include "croquis/silhouette/solid.h"
#include "silhouette/figure_fixtures.h"
#include "silhouette/surface_quality.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::silhouette;
using std::numbers::pi;

namespace {

struct Thickened {
  SheetSampling sheets;
  SheetOperator op;
  Eigen::VectorXd thickness;
};

Thickened thicken(const LabelledFigure& figure) {
  Progress progress;
  const Skeleton skeleton = test::skeleton_of(figure);
  Thickened result;
  const SheetSampling& sheets = result.sheets = sample_sheets(figure, skeleton, progress);
  const std::vector<LiftedPlace> nodes = locate_nodes(figure, skeleton, sheets);
  result.op = make_sheet_operator(sheets);
  const NodeExtension extension(result.op, nodes, skeleton);
  result.thickness = sheet_thickness(result.sheets, result.op, skeleton, nodes, extension, progress);
  return result;
}

Thickened thicken(const test::FigureFixture& fixture) { return thicken(fixture.figure); }

/// From the circle of the rim's radius, as parts of it, at all places in the outer half of the radius but for those on
/// the chord between the rim and its first row.
std::vector<double> rim_deviations(const LabelledFigure& figure) {
  const Thickened result = thicken(figure);
  const RimDistances rim = rim_distances(result.sheets, 0.5);
  std::vector<double> deviations;
  for (std::size_t v = 0; v < rim.nearest.size(); ++v) {
    if (rim.nearest[v] == no_index) continue;
    const double radius = rim.edges[rim.nearest[v]].radius;
    if (rim.distance[v] < 0.03 * radius) continue;
    const double reach = std::hypot(radius - rim.distance[v], result.thickness[static_cast<Eigen::Index>(v)]);
    deviations.push_back(std::abs(reach - radius) / radius);
  }
  return deviations;
}

/// A circle of radius 120 with waves, in parts of the radius: a flower, cloud or star.
LabelledFigure waved_figure(int points, double waves) {
  std::vector<Vec2> outline;
  for (int k = 0; k < 400; ++k) {
    const double angle = 2 * pi * k / 400;
    outline.push_back(120 * (1 + waves * std::cos(points * angle)) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return test::figure_of_outline("waves", outline, 3).figure;
}

/// Vertices near the middle that are higher than all others around them.
int summits(const Thickened& result, double within) {
  constexpr double around = 20;
  int count = 0;
  for (Index v = 0; v < result.op.position.size(); ++v) {
    bool highest = result.op.position[v].norm() < within;
    for (Index w = 0; highest && w < result.op.position.size(); ++w) {
      highest = v == w || (result.op.position[v] - result.op.position[w]).norm() > around ||
                result.thickness[w] < result.thickness[v];
    }
    count += highest ? 1 : 0;
  }
  return count;
}

double height_near(const Thickened& result, const Vec2& place) {
  Index nearest = 0;
  for (Index v = 0; v < result.op.position.size(); ++v) {
    if ((result.op.position[v] - place).norm() < (result.op.position[nearest] - place).norm()) nearest = v;
  }
  return result.thickness[nearest];
}

}  // namespace

TEST_CASE("the stiffness annihilates constants and gives a quadratic's Laplacian in the mean") {
  const SheetOperator op = thicken(test::disk_figure()).op;
  const Eigen::Index count = op.stiffness.cols();
  CHECK((op.stiffness * Eigen::VectorXd::Ones(count)).cwiseAbs().maxCoeff() < 1e-9);
  CHECK(op.area.sum() == Approx(pi * 1e4).epsilon(0.001));
  Eigen::VectorXd square(count);
  for (Eigen::Index v = 0; v < count; ++v) square[v] = op.position[static_cast<std::size_t>(v)].squaredNorm();
  CHECK(square.dot(op.stiffness * square) == Approx(4 * pi * 1e8 / 2).epsilon(0.01));
}

TEST_CASE("thickness is zero exactly on the boundary and positive inside") {
  for (const test::FigureFixture& fixture : {test::crossed_capsules_figure(), test::snake_figure()}) {
    const Thickened result = thicken(fixture);
    for (Eigen::Index v = 0; v < result.thickness.size(); ++v) {
      CHECK((result.thickness[v] == 0) == (result.op.on_boundary[static_cast<std::size_t>(v)] != 0));
      CHECK(result.thickness[v] >= 0);
    }
  }
}

TEST_CASE("a disk is as thick as the ball, a straight tube as the cylinder") {
  const Thickened disk = thicken(test::disk_figure());
  for (Eigen::Index v = 0; v < disk.thickness.size(); ++v) {
    const double distance = disk.op.position[static_cast<std::size_t>(v)].norm();
    CHECK(std::abs(std::hypot(disk.thickness[v], distance) - 100) < 1);
  }
  const Thickened capsule = thicken(test::capsule_figure());
  for (Eigen::Index v = 0; v < capsule.thickness.size(); ++v) {
    const Vec2& place = capsule.op.position[static_cast<std::size_t>(v)];
    if (place.x() < 60 || place.x() > 160) continue;
    CHECK(std::abs(std::hypot(capsule.thickness[v], place.y()) - 40) < 0.8);
  }
}

TEST_CASE("rims are circles to a hundredth of their radius, on bent tubes too") {
  for (const test::FigureFixture& fixture : {test::ring_figure(), test::capsule_figure(), test::snake_figure(),
                                             test::trefoil_figure(), test::linked_rings_figure()}) {
    const std::vector<double> deviations = rim_deviations(fixture.figure);
    REQUIRE(deviations.size() > 100);
    INFO(fixture.figure.objects[0].name << " " << deviations.size());
    CHECK(test::spread_of(deviations).mean <= 0.009);
  }
  // Without an end, where a tube goes over into half a ball, they are so everywhere.
  for (const test::FigureFixture& fixture :
       {test::ring_figure(), test::trefoil_figure(), test::linked_rings_figure()}) {
    CHECK(test::spread_of(rim_deviations(fixture.figure)).p95 <= 0.01);
  }
}

TEST_CASE("rims of whole drawings are circles to a hundredth of their radius in the mean") {
  Progress progress;
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    for (const LabelledFigure& figure : label(named.sketch.drawing, {}, progress).figures) {
      CHECK(test::spread_of(rim_deviations(figure)).mean <= 0.01);
    }
  }
}

TEST_CASE("how far a rim turns is its curvature times the radius of the surface") {
  const Thickened disk = thicken(test::disk_figure());
  const Eigen::VectorXd turns = rim_turn(disk.sheets);
  for (Eigen::Index v = 0; v < turns.size(); ++v) {
    CHECK(turns[v] == Approx(disk.op.on_boundary[static_cast<std::size_t>(v)] ? 1.0 : 0.0).margin(0.02));
  }
  const Thickened capsule = thicken(test::capsule_figure());
  const Eigen::VectorXd capsule_turns = rim_turn(capsule.sheets);
  for (Eigen::Index v = 0; v < capsule_turns.size(); ++v) {
    const double x = capsule.op.position[static_cast<std::size_t>(v)].x();
    if (x > 60 && x < 160) CHECK(capsule_turns[v] == Approx(0).margin(0.01));
  }
}

TEST_CASE("where three limbs meet the surface is neither pinched nor blown up") {
  std::vector<Vec2> outline;
  for (int k = 0; k < 720; ++k) {
    const double angle = 2 * pi * k / 720;
    outline.push_back((90 + 50 * std::cos(3 * angle)) * Vec2(std::cos(angle), std::sin(angle)));
  }
  const Thickened result = thicken(test::figure_of_outline("star", outline, 2));
  double centre = 0;
  double highest = 0;
  for (Eigen::Index v = 0; v < result.thickness.size(); ++v) {
    highest = std::max(highest, result.thickness[v]);
    if (result.op.position[static_cast<std::size_t>(v)].norm() < 4) centre = std::max(centre, result.thickness[v]);
  }
  CHECK(centre == Approx(40).epsilon(0.1));  // the radius of the circle inscribed there
  CHECK(highest < 1.25 * centre);
}

TEST_CASE("stars and clouds have one summit, and all of their points are alike") {
  for (const int points : {5, 8, 12, 17}) {
    for (const double waves : {0.15, 0.35}) {
      INFO(points << " points, " << waves);
      const Thickened result = thicken(waved_figure(points, waves));
      CHECK(summits(result, 120 * (1 - waves)) == 1);
      double low = 1e300;
      double high = 0;
      for (int k = 0; k < points; ++k) {
        const double angle = 2 * pi * k / points;
        const double height = height_near(result, 72 * (1 - waves) * Vec2(std::cos(angle), std::sin(angle)));
        low = std::min(low, height);
        high = std::max(high, height);
      }
      CHECK(low > 0.83 * high);
    }
  }
}

TEST_CASE("a drawn star is highest in the middle and falls evenly into its points") {
  std::vector<Vec2> outline;
  for (int k = 0; k < 10; ++k) {
    const double angle = pi * (k / 5.0 + 0.5);
    const double next = pi * ((k + 1) / 5.0 + 0.5);
    const Vec2 begin = (k % 2 == 0 ? 160 : 60) * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 end = (k % 2 == 0 ? 60 : 160) * Vec2(std::cos(next), std::sin(next));
    for (int i = 0; i < 28; ++i) outline.push_back(begin + i / 28.0 * (end - begin));
  }
  const Thickened result = thicken(test::figure_of_outline("star", outline, 2));
  // The five sectors are alike, however the middle was triangulated.
  std::array<double, 5> lowest;
  lowest.fill(1e300);
  for (Eigen::Index v = 0; v < result.thickness.size(); ++v) {
    const Vec2& place = result.op.position[static_cast<std::size_t>(v)];
    if (place.norm() < 20 || place.norm() > 30) continue;
    const double turns = std::atan2(place.y(), place.x()) / (2 * pi) + 1.85;
    double& low = lowest[static_cast<std::size_t>(std::floor(5 * turns)) % 5];
    low = std::min(low, result.thickness[v]);
  }
  const auto [low, high] = std::minmax_element(lowest.begin(), lowest.end());
  CHECK(*low > 0.93 * *high);
  CHECK(*low > 40);
}

TEST_CASE("equal node values extend to a constant, and differing ones stay between their extremes") {
  Progress progress;
  const test::FigureFixture fixture = test::snake_figure();
  const Skeleton skeleton = test::skeleton_of(fixture.figure);
  const SheetSampling sheets = sample_sheets(fixture.figure, skeleton, progress);
  const std::vector<LiftedPlace> nodes = locate_nodes(fixture.figure, skeleton, sheets);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  const NodeExtension extension(make_sheet_operator(sheets), nodes, skeleton);
  const Eigen::VectorXd same = extension.extend(Eigen::VectorXd::Constant(count, 3));
  CHECK((same.array() - 3).abs().maxCoeff() < 1e-6);
  // Along the snake, from one end to the other.
  const std::vector<std::vector<Index>> neighbours = skeleton.neighbours();
  std::vector<Index> along;
  for (Index node = 0; node < neighbours.size() && along.empty(); ++node) {
    if (neighbours[node].size() == 1) along = {node, neighbours[node].front()};
  }
  while (neighbours[along.back()].size() == 2) {
    const std::vector<Index>& both = neighbours[along.back()];
    along.push_back(both[0] == along[along.size() - 2] ? both[1] : both[0]);
  }
  REQUIRE(along.size() == nodes.size());
  Eigen::VectorXd given(count);
  for (std::size_t i = 0; i < along.size(); ++i) {
    given[along[i]] = 1 + static_cast<double>(i) / static_cast<double>(along.size() - 1);
  }
  const Eigen::VectorXd rising = extension.extend(given);
  CHECK(rising.minCoeff() > 0.95);
  CHECK(rising.maxCoeff() < 2.05);
  CHECK(value_at(nodes[along[along.size() / 2]], rising) == Approx(1.5).epsilon(0.02));
}
