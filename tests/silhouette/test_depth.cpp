// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/depth.h"
#include "silhouette/figure_fixtures.h"
#include "support/random.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::skeleton_of;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Values and gradients at two places of S = a x^2 + b x + c y^2 + d y + e x y + f, rows (z_i, gx_i, gy_i, z_k, …).
Matrix6 interpolation_matrix(const Vec2& from, const Vec2& to) {
  Matrix6 rows;
  int row = 0;
  for (const Vec2& p : {from, to}) {
    const double x = p.x();
    const double y = p.y();
    rows.row(row++) << x * x, x, y * y, y, x * y, 1;
    rows.row(row++) << 2 * x, 1, 0, 0, y, 0;
    rows.row(row++) << 0, 0, 2 * y, 1, x, 0;
  }
  return rows;
}

Vector6 as_vector(const EdgeRow& row) { return Vector6(row.data()); }

DepthResult solve(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings = {}) {
  Progress progress;
  return solve_depth(skeleton, figure, settings, progress);
}

double mean_height(const Skeleton& skeleton) {
  double sum = 0;
  for (const SkeletonNode& node : skeleton.nodes) sum += std::abs(node.z);
  return sum / static_cast<double>(skeleton.nodes.size());
}

/// Every pair that the figure puts above one another keeps its distance.
void check_order(const Skeleton& skeleton, const LabelledFigure& figure) {
  for (const CollisionRow& row : collision_rows(skeleton, figure)) {
    CHECK(skeleton.nodes[row.upper].z - skeleton.nodes[row.lower].z >= row.bound - 1e-6 * skeleton.scale);
  }
}

/// The same skeleton in a drawing that was turned and enlarged; the labels stay.
Skeleton transformed(Skeleton skeleton, double angle, double factor) {
  const Eigen::Rotation2Dd turn(angle);
  const auto move = [&](const Vec2& p) -> Vec2 { return factor * (turn * p) + Vec2(17, -400); };
  for (SkeletonNode& node : skeleton.nodes) {
    node.position = move(node.position);
    node.radius *= factor;
    for (Vec2& end : node.chord) end = move(end);
    for (ChordPart& part : node.parts) part = {move(part.middle), factor * part.length};
  }
  skeleton.scale *= factor;
  return skeleton;
}

}  // namespace

TEST_CASE("the continuity row is the left null vector of the interpolation matrix") {
  test::Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 from(random.between(-2, 2), random.between(-2, 2));
    Vec2 to(random.between(-2, 2), random.between(-2, 2));
    if (i % 4 == 1) to.y() = from.y();
    if (i % 4 == 2) to.x() = from.x();
    if (i % 4 == 3) to = from * random.between(1.1, 3);
    const Matrix6 matrix = interpolation_matrix(from, to);
    const Vector6 row = as_vector(continuity_row(to - from));
    CHECK((row.transpose() * matrix).cwiseAbs().maxCoeff() < 1e-12 * row.cwiseAbs().maxCoeff() * 20);
    Eigen::FullPivLU<Matrix6> lu(matrix);
    lu.setThreshold(1e-9);
    CHECK(lu.rank() == 5);
  }
}

TEST_CASE("the curvature rows give the least thin-plate energy over the free coefficient") {
  test::Random random(5);
  for (const double poisson : {0.0, 0.2, 0.35, 0.5}) {
    for (int i = 0; i < 100; ++i) {
      const Vec2 from(random.between(-2, 2), random.between(-2, 2));
      const Vec2 to = from + Vec2(random.between(0.2, 2), random.between(-2, 2));
      const double scale = random.between(0.5, 3);
      // Any polynomial gives ends that a patch exists for.
      Vector6 patch;
      for (double& value : patch) value = random.between(-1, 1);
      const Vector6 ends = interpolation_matrix(from, to) * patch;

      // All patches through these ends: patch + c (m.(p - from))^2. Least squares over c by three values of a parabola.
      const Vec2 m = left_of((to - from).normalized());
      const auto energy = [&](double c) {
        const double xx = 2 * (patch[0] + c * m.x() * m.x());
        const double yy = 2 * (patch[2] + c * m.y() * m.y());
        const double xy = patch[4] + 2 * c * m.x() * m.y();
        const double bending = (xx + yy) * (xx + yy) - 2 * (1 - poisson) * (xx * yy - xy * xy);
        return scale * (to - from).norm() * bending;
      };
      const double bend = (energy(1) + energy(-1) - 2 * energy(0)) / 2;
      const double slope = (energy(1) - energy(-1)) / 2;
      const double least = energy(0) - slope * slope / (4 * bend);

      double rows = 0;
      for (const EdgeRow& row : curvature_rows(to - from, scale, poisson))
        rows += std::pow(as_vector(row).dot(ends), 2);
      CHECK(rows == Approx(least).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("tubes that don't cover each other stay in the sketch plane") {
  for (const auto& fixture : {test::disk_figure(), test::ring_figure(), test::capsule_figure()}) {
    Skeleton skeleton = skeleton_of(fixture.figure);
    const DepthResult result = solve(skeleton, fixture.figure);
    CHECK(result.rows == 0);
    CHECK(result.iterations == 0);
    for (const SkeletonNode& node : skeleton.nodes) CHECK(std::abs(node.z) + node.gradient.norm() < 1e-9);
  }
}

TEST_CASE("crossing tubes are put in the drawn order and keep their distance") {
  for (const auto& fixture : {test::crossed_capsules_figure(), test::figure_eight_figure(), test::snake_figure(),
                              test::linked_rings_figure(), test::trefoil_figure()}) {
    Skeleton skeleton = skeleton_of(fixture.figure);
    const DepthResult result = solve(skeleton, fixture.figure);
    INFO(fixture.figure.objects.front().name);
    CHECK(result.rows > 0);
    CHECK(result.rows < 1000);
    CHECK(*std::max_element(result.uncertainty.begin(), result.uncertainty.end()) <= 1e-8);
    CHECK(result.iterations <= 25);
    CHECK(result.collisions.empty());
    CHECK(result.split_chords == 0);
    check_order(skeleton, fixture.figure);
  }
}

TEST_CASE("a capsule in front of another is in front by both radii and the gap") {
  const auto fixture = test::crossed_capsules_figure();
  Skeleton skeleton = skeleton_of(fixture.figure);
  solve(skeleton, fixture.figure);
  double front = -1e9;
  double back = 1e9;
  for (const SkeletonNode& node : skeleton.nodes) {
    const bool at_crossing = (node.position - Vec2(20, 0)).norm() < 10;
    if (at_crossing && node.object == 0) front = std::max(front, node.z);
    if (at_crossing && node.object == 1) back = std::min(back, node.z);
  }
  CHECK(front - back == Approx(70 + 0.1 * skeleton.scale).epsilon(0.02));
  CHECK(front > 0);
  CHECK(back < 0);
}

TEST_CASE("a joined part's rim lies on the front of the part behind it, however thick that is") {
  Skeleton skeleton;
  skeleton.scale = 2;
  skeleton.nodes.resize(2);
  SkeletonNode& upper = skeleton.nodes[0];
  upper.radius = 1;
  upper.chord = {Vec2(0, -1), Vec2(0, 1)};
  upper.crossed = {{0, 0}};
  SkeletonNode& lower = skeleton.nodes[1];
  lower.position = Vec2(0.5, 0);
  lower.radius = 3;
  lower.crossed = {{0, 1}};
  lower.object = 1;
  LabelledFigure figure;
  figure.faces = {1};
  DepthSettings settings;
  settings.attachments.held[{0, 1}] = {Hold::Joined, 0.1};
  // The front of the part behind is half an ellipsoid of radius 3; the nearest place of the rim is (0, 1).
  const double round = std::sqrt(3 * 3 - 0.5 * 0.5 - 1);
  for (const double thickness : {0.3, 0.5, 1.0}) {
    for (const double other : {0.6, 1.0}) {
      settings.thickness = {other, thickness};
      const std::vector<CollisionRow> rows = collision_rows(skeleton, figure, settings);
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].upper == 0);
      CHECK(rows[0].bound == Approx(thickness * round));
    }
  }
}

TEST_CASE("heights don't depend on how the drawing is turned and grow with it") {
  const auto fixture = test::trefoil_figure();
  Skeleton skeleton = skeleton_of(fixture.figure);
  const double factor = GENERATE(1.0, 0.001, 3.0, 1e5);
  const double angle = GENERATE(0.0, 0.3, std::numbers::pi / 2);
  Skeleton moved = transformed(skeleton, angle, factor);
  solve(skeleton, fixture.figure);
  solve(moved, fixture.figure);
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) {
    CHECK(std::abs(moved.nodes[n].z / factor - skeleton.nodes[n].z) < 1e-6 * skeleton.scale);
    const Vec2 turned = Eigen::Rotation2Dd(angle) * skeleton.nodes[n].gradient;
    CHECK((moved.nodes[n].gradient - turned).norm() < 1e-6);
  }
}

TEST_CASE("heights hardly depend on the number of nodes") {
  const auto fixture = GENERATE(test::snake_figure(), test::trefoil_figure());
  Skeleton coarse = skeleton_of(fixture.figure, 0.6);
  Skeleton fine = skeleton_of(fixture.figure, 0.15);
  solve(coarse, fixture.figure);
  solve(fine, fixture.figure);
  CHECK(mean_height(fine) == Approx(mean_height(coarse)).epsilon(0.1));
}

TEST_CASE("weights do what their names say") {
  const auto fixture = test::trefoil_figure();
  const auto heights = [&](double curvature, double orientation, double distance) {
    Skeleton skeleton = skeleton_of(fixture.figure);
    DepthSettings settings;
    settings.options.weight_curvature = curvature;
    settings.options.weight_orientation = orientation;
    settings.options.weight_distance = distance;
    solve(skeleton, fixture.figure, settings);
    double slope = 0;
    for (const SkeletonNode& node : skeleton.nodes) slope += node.gradient.squaredNorm();
    return std::pair{mean_height(skeleton), slope};
  };
  const auto plain = heights(1, 0.1, 0.1);
  CHECK(heights(1, 0.1, 1).first < plain.first);
  CHECK(heights(1, 0.001, 0.001).first > plain.first);
  CHECK(heights(1, 1, 0.1).second < plain.second);
}

TEST_CASE("an object's own weights move it and hardly the others") {
  const auto fixture = test::crossed_capsules_figure();
  const auto reach = [&](const DepthSettings& settings) {
    Skeleton skeleton = skeleton_of(fixture.figure);
    solve(skeleton, fixture.figure, settings);
    std::array<double, 2> highest{};
    for (const SkeletonNode& node : skeleton.nodes) {
      highest[node.object] = std::max(highest[node.object], std::abs(node.z));
    }
    return highest;
  };
  const auto plain = reach({});
  DepthSettings settings;
  settings.object_weights = {{1, 0.1, 1}, {1, 0.1, 0.1}};
  const auto pinned = reach(settings);
  CHECK(pinned[0] < 0.5 * plain[0]);
  CHECK(pinned[1] > plain[1]);
}

TEST_CASE("a contradiction is reported with both strokes, and the rest is still solved") {
  const auto fixture = test::crossed_capsules_figure();
  Skeleton skeleton = skeleton_of(fixture.figure);
  // Two nodes that lie on each other's sheets in the same face: each would have to be above the other.
  Index a = no_index;
  Index b = no_index;
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    if ((skeleton.nodes[n].position - Vec2(20, 0)).norm() > 8) continue;
    (skeleton.nodes[n].object == 0 ? a : b) = n;
  }
  REQUIRE(a != no_index);
  REQUIRE(b != no_index);
  skeleton.nodes[a].crossed.push_back(skeleton.nodes[b].place);
  skeleton.nodes[a].parts.push_back({skeleton.nodes[a].position, 1});
  skeleton.nodes[b].crossed.push_back(skeleton.nodes[a].place);
  skeleton.nodes[b].parts.push_back({skeleton.nodes[b].position, 1});
  const DepthResult result = solve(skeleton, fixture.figure);
  REQUIRE_FALSE(result.collisions.empty());
  for (const DepthCollision& collision : result.collisions) CHECK(collision.shortfall > 0.01 * skeleton.scale);

  const Findings findings = depth_findings(result, skeleton, fixture.figure, fixture.drawing);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "W_COLLISION");
  CHECK(findings[0].severity == Severity::Warning);
  CHECK(findings[0].message.find_first_of("0123456789") == std::string::npos);  // the subjects have the places
  std::vector<std::string> ids;
  for (const Subject& subject : findings[0].subjects) {
    CHECK(subject.kind == SubjectKind::Stroke);
    CHECK(subject.at.size() == 2);
    ids.push_back(subject.id);
  }
  const auto names = [&](Index object) {
    return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
      const auto& strokes = fixture.figure.objects[object].strokes;
      return std::any_of(strokes.begin(), strokes.end(),
                         [&](Index stroke) { return fixture.drawing.strokes[stroke].id == id; });
    });
  };
  CHECK(names(0));
  CHECK(names(1));
}

TEST_CASE("a chord that spans places of opposite order is split and then tilts") {
  // Planted: away from their middles, the chords of two crossing bars also claim a place of the opposite order.
  const auto fixture = test::crossed_capsules_figure();
  Skeleton skeleton = skeleton_of(fixture.figure);
  const auto nearest = [&](Index object, const Vec2& place) {
    Index best = no_index;
    for (Index n = 0; n < skeleton.nodes.size(); ++n) {
      if (skeleton.nodes[n].object != object) continue;
      const double distance = (skeleton.nodes[n].position - place).norm();
      if (best == no_index || distance < (skeleton.nodes[best].position - place).norm()) best = n;
    }
    return best;
  };
  const Index front = nearest(0, {20, 0});
  const Index back = nearest(1, {20, 0});
  const SheetPlace above = skeleton.nodes[front].place;
  const SheetPlace below = skeleton.nodes[back].place;
  const Vec2 aside = skeleton.nodes[back].position + Vec2(25, 0);
  skeleton.nodes[back].crossed.push_back(above);
  skeleton.nodes[back].parts.push_back({aside, 10});
  const Vec2 other = skeleton.nodes[front].position + Vec2(0, 30);
  skeleton.nodes[front].crossed.push_back(below);
  skeleton.nodes[front].parts.push_back({other, 10});
  const std::size_t nodes = skeleton.nodes.size();
  const DepthResult result = solve(skeleton, fixture.figure);
  CHECK(result.split_chords >= 2);
  CHECK(skeleton.nodes.size() >= nodes + 2);
  CHECK(result.collisions.empty());
  check_order(skeleton, fixture.figure);
}

TEST_CASE("three disks of which each covers the next are bent, not refused") {
  std::vector<test::FixtureContour> disks;
  std::vector<Vec2> centres;
  for (Index k = 0; k < 3; ++k) {
    const double turn = 2 * std::numbers::pi * k / 3 + 0.2;
    centres.emplace_back(104 * std::cos(turn), 104 * std::sin(turn));
    disks.push_back({{}, 1, k});
    for (int i = 0; i < 120; ++i) {
      const double angle = 2 * std::numbers::pi * i / 120;
      disks.back().points.push_back(centres.back() + 100 * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  const std::vector<std::string> names = {"a", "b", "c"};
  const auto covered = [&](Index contour, double position) {
    const auto& points = disks[contour].points;
    const Vec2& place = points[static_cast<std::size_t>(std::lround(position)) % points.size()];
    return (place - centres[(contour + 1) % 3]).norm() < 100 ? 1 : 0;
  };
  const auto fixture = test::figure_of_contours(disks, names, 6, covered);
  Skeleton skeleton = skeleton_of(fixture.figure);
  REQUIRE(skeleton.nodes.size() == 3);
  const DepthResult result = solve(skeleton, fixture.figure);
  CHECK(result.split_chords == 3);
  CHECK(skeleton.nodes.size() == 9);
  CHECK(result.collisions.empty());
  check_order(skeleton, fixture.figure);
  for (const SkeletonNode& node : skeleton.nodes) {
    CHECK(node.radius > 20);
    CHECK(node.radius < 105);
  }
}

TEST_CASE("every sample sketch gets heights in its drawn order within 25 iterations") {
  for (const auto& [name, sketch] : test::sketches_with_random_ones(12)) {
    INFO(name);
    Progress progress;
    const LabelledDrawing labelled = label(sketch.drawing, {}, progress);
    CHECK_FALSE(has_warnings(labelled.findings));
    for (const LabelledFigure& figure : labelled.figures) {
      Skeleton skeleton = skeleton_of(figure);
      const DepthResult result = solve(skeleton, figure);
      CHECK(*std::max_element(result.uncertainty.begin(), result.uncertainty.end()) <= 1e-8);
      CHECK(result.iterations <= 25);
      CHECK(result.collisions.empty());
      check_order(skeleton, figure);
    }
  }
}

TEST_CASE("objects that nothing couples don't change each other") {
  const auto alone = test::figure_eight_figure();
  Skeleton one = skeleton_of(alone.figure);
  Skeleton two = one;
  solve(one, alone.figure);
  // A second, uncoupled copy far away, on nobody's panels.
  const std::size_t count = two.nodes.size();
  const auto edges = two.edges;
  for (std::size_t n = 0; n < count; ++n) {
    SkeletonNode node = two.nodes[n];
    node.position += Vec2(5000, 0);
    node.crossed.clear();
    node.parts.clear();
    two.nodes.push_back(node);
  }
  for (const auto& [a, b] : edges) two.edges.push_back({a + static_cast<Index>(count), b + static_cast<Index>(count)});
  solve(two, alone.figure);
  for (std::size_t n = 0; n < count; ++n) {
    CHECK(two.nodes[n].z == one.nodes[n].z);
    CHECK(std::abs(two.nodes[count + n].z) < 1e-9);
  }
}
