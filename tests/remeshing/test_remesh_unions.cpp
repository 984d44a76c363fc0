// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

void check_uncut(const RemeshResult& result) {
  const MeshReport report = report_of(result.mesh);
  CHECK(report.self_intersections == std::size_t{0});
  CHECK(report.nonmanifold_edges == 0);
  CHECK(report.nonmanifold_vertices == 0);
  CHECK(report.oriented);
  CHECK(result.checks.self_intersections == 0);
  CHECK(result.checks.piece_crossings == 0);
  CHECK_FALSE(warns(result, "W_CUTS_ITSELF"));
  CHECK(validate(result.mesh).empty());
}

void check_solid(const RemeshResult& result, std::size_t components, std::int64_t euler, double volume,
                 double tolerance = 0.02) {
  check_uncut(result);
  const MeshReport report = report_of(result.mesh);
  CHECK(report.closed);
  CHECK(report.components == components);
  CHECK(report.euler_characteristic == euler);
  CHECK(*report.volume == Approx(volume).epsilon(tolerance));
}

PolyMesh ball(const Vec3& centre, double radius = 1, int levels = 4) {
  return translated(scaled(round_sphere(levels), radius), centre);
}

double ball_volume(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius; }

/// Of two unit balls at a distance: the lens of two caps is counted once.
double two_balls(double distance) {
  const double height = 1 - distance / 2;
  return 2 * ball_volume(1) - 2 * std::numbers::pi * height * height * (3 - height) / 3;
}

/// Share of a box that a solid fills, by chance.
double volume_by_chance(const std::function<bool(const Vec3&)>& is_inside, const Vec3& low, const Vec3& high) {
  constexpr int samples = 400000;
  Random random(7);
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = low[axis] + random.unit() * (high[axis] - low[axis]);
    inside += is_inside(p) ? 1 : 0;
  }
  return (high - low).prod() * inside / samples;
}

PolyMesh plate(const Vec3& size, const Vec3& low) {
  return transformed(divided_box(24), Eigen::Translation3d(low) * Eigen::Scaling(size));
}

}  // namespace

TEST_CASE("two balls that cross become one solid, whatever their distance") {
  for (const double distance : {0.3, 1.0, 1.5, 1.9}) {
    CAPTURE(distance);
    const RemeshResult result = remesh(merged(ball(Vec3(0, 0, 0)), ball(Vec3(distance, 0.01, 0.02))));
    check_solid(result, 1, 2, two_balls(Vec3(distance, 0.01, 0.02).norm()));
    CHECK(result.checks.united_pieces == 2);
    CHECK(warns(result, "W_PIECES_UNITED"));
    for (const Vec3& p : result.mesh.positions) {
      const double away = std::min(std::abs(p.norm() - 1), std::abs((p - Vec3(distance, 0.01, 0.02)).norm() - 1));
      CHECK(away < 0.002);
    }
  }
}

TEST_CASE("balls that all but touch stay two where their surfaces don't cross, else become one") {
  for (const double gap : {0.1, 0.02, 0.005, 0.001, 1e-6, -0.001, -0.01}) {
    CAPTURE(gap);
    const RemeshResult result = remesh(merged(ball(Vec3(0, 0, 0)), ball(Vec3(2 + gap, 0, 0))));
    const std::size_t components = report_of(result.mesh).components;
    CHECK((components == 1 || components == 2));
    check_solid(result, components, 2 * static_cast<std::int64_t>(components), 2 * ball_volume(1));
    CHECK(result.checks.united_pieces == (components == 1 ? 2U : 0U));
    if (gap > 0.01) CHECK(components == 2);
  }
}

TEST_CASE("a ball that comes through the wall of an open tube is one with it, and the tube's ends stay open") {
  const PolyMesh tube = open_tube(1, 4, 80, 60);
  const RemeshResult result = remesh(merged(tube, ball(Vec3(1, 0, 2), 0.5)));
  check_uncut(result);
  const MeshReport report = report_of(result.mesh);
  CHECK(report.components == 1);
  CHECK(report.boundary_loops == 2);
  CHECK(report.euler_characteristic == 0);
  for (const Vec3& p : result.mesh.positions) {
    const double to_tube = std::abs(p.head<2>().norm() - 1), to_ball = std::abs((p - Vec3(1, 0, 2)).norm() - 0.5);
    CHECK(std::min(to_tube, to_ball) < 0.02);
    CHECK(p.head<2>().norm() > 0.95);          // nothing is left inside the tube
    CHECK((p - Vec3(1, 0, 2)).norm() > 0.48);  // nor inside the ball
  }
}

TEST_CASE("a ball stuck in the end of a tube closes that end alone") {
  const RemeshResult result = remesh(merged(open_tube(1, 4, 80, 60), ball(Vec3(0, 0, 4), 1.2)));
  check_uncut(result);
  const MeshReport report = report_of(result.mesh);
  CHECK(report.components == 1);
  CHECK(report.boundary_loops == 1);
  CHECK(report.euler_characteristic == 1);
}

TEST_CASE("sheets that cross are cut off at each other or joined, without intersections") {
  for (const double angle : {0.1, 0.5, 1.5}) {
    CAPTURE(angle);
    const PolyMesh flat = translated(sheet(24, 24), Vec3(-12, -12, 0));
    const RemeshResult result = remesh(merged(flat, rotated(flat, angle, Vec3(1, 0.2, 0).normalized())));
    check_uncut(result);
    CHECK(result.mesh.face_count() > 500);
  }
}

TEST_CASE("a shell that another body crosses keeps its cavity") {
  const PolyMesh hollow = merged(ball(Vec3::Zero(), 1, 5), flipped(ball(Vec3::Zero(), 0.6, 5)));
  const Vec3 aside(1.1, 0, 0);
  const RemeshResult result = remesh(merged(hollow, ball(aside, 0.3)));  // doesn't reach the cavity
  const double volume =
      volume_by_chance([&](const Vec3& p) { return (p.norm() < 1 && p.norm() > 0.6) || (p - aside).norm() < 0.3; },
                       Vec3(-1, -1, -1), Vec3(1.4, 1, 1));
  check_solid(result, 2, 4, volume);
  CHECK(result.checks.united_pieces == 2);
}

TEST_CASE("a cavity that comes through its body opens it, and a body in a cavity stays") {
  const Vec3 aside(0.6, 0, 0);
  const RemeshResult open = remesh(merged(ball(Vec3::Zero(), 1, 4), flipped(ball(aside, 0.6, 4))));
  check_solid(open, 1, 2,
              volume_by_chance([&](const Vec3& p) { return p.norm() < 1 && (p - aside).norm() > 0.6; },
                               Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  // A ball across the inner skin alone: part of it hangs in the cavity.
  const PolyMesh hollow = merged(ball(Vec3::Zero(), 1, 5), flipped(ball(Vec3::Zero(), 0.6, 5)));
  const RemeshResult bump = remesh(merged(hollow, ball(aside, 0.25)));
  check_solid(
      bump, 2, 4,
      volume_by_chance([&](const Vec3& p) { return p.norm() < 1 && (p.norm() > 0.6 || (p - aside).norm() < 0.25); },
                       Vec3(-1, -1, -1), Vec3(1, 1, 1)));
}

TEST_CASE("two cavities of a body that cross become one") {
  const Vec3 left(-0.2, 0, 0), right(0.2, 0, 0);
  const PolyMesh body = merged(ball(Vec3::Zero(), 1, 5), flipped(ball(left, 0.4, 4)));
  const RemeshResult result = remesh(merged(body, flipped(ball(right, 0.4, 4))));
  check_solid(result, 2, 4,
              volume_by_chance(
                  [&](const Vec3& p) { return p.norm() < 1 && (p - left).norm() > 0.4 && (p - right).norm() > 0.4; },
                  Vec3(-1, -1, -1), Vec3(1, 1, 1)));
}

TEST_CASE("of a chain of pieces those that cross become one, the others keep their bytes") {
  const PolyMesh alone = ball(Vec3(0, 5, 0));
  const PolyMesh chain = merged(merged(ball(Vec3(0, 0, 0)), ball(Vec3(1.5, 0, 0))), ball(Vec3(3, 0, 0)));
  const RemeshResult result = remesh(merged(alone, chain));
  check_solid(result, 2, 4, ball_volume(1) + two_balls(1.5) * 2 - ball_volume(1));
  CHECK(result.checks.united_pieces == 3);
  // Cubes of the same size, as the mean edge is the same for all balls.
  const PolyMesh apart = merged(alone, merged(merged(ball(Vec3(0, 0, 0)), ball(Vec3(5, 0, 0))), ball(Vec3(10, 0, 0))));
  const RemeshResult other = remesh(apart);
  const std::size_t count = other.mesh.face_count() / 4;
  std::size_t same = 0;
  while (same < count && result.mesh.positions[same] == other.mesh.positions[same]) ++same;
  CHECK(2 * same >= count);  // all vertices of the first ball: half as many as its faces
}

TEST_CASE("three bodies that cross in one place, and a ring through a ring") {
  const Vec3 a(0, 0, 0), b(1.1, 0, 0), c(0.55, 0.9, 0);
  check_solid(remesh(merged(merged(ball(a), ball(b)), ball(c))), 1, 2,
              volume_by_chance([&](const Vec3& p) { return p.norm() < 1 || (p - b).norm() < 1 || (p - c).norm() < 1; },
                               Vec3(-1, -1, -1), Vec3(2.1, 1.9, 1)));
  const PolyMesh ring = ring_torus(120, 60);
  const PolyMesh other = translated(rotated(ring, std::numbers::pi / 2, Vec3(1, 0, 0)), Vec3(0.25, 0, 0));
  const auto in_ring = [](double around, double aside) { return std::hypot(around - 1, aside) < 0.4; };
  const double volume = volume_by_chance(
      [&](const Vec3& p) {
        return in_ring(p.head<2>().norm(), p.z()) || in_ring(std::hypot(p.x() - 0.25, p.z()), p.y());
      },
      Vec3(-1.4, -1.4, -1.4), Vec3(1.65, 1.4, 1.4));
  const RemeshResult rings = remesh(merged(ring, other));
  check_uncut(rings);
  CHECK(report_of(rings.mesh).closed);
  CHECK(*report_of(rings.mesh).volume == Approx(volume).epsilon(0.02));
}

TEST_CASE("thin plates that cross or lie nearer than a cube come out without intersections") {
  const PolyMesh lying = plate(Vec3(1, 1, 0.03), Vec3(0, 0, 0));
  const PolyMesh standing = plate(Vec3(0.03, 1, 1), Vec3(0.51, 0.003, -0.5));
  const RemeshResult cross = remesh(merged(lying, standing));
  check_solid(cross, 1, 2, 0.06 - 0.03 * 0.03, 0.06);
  for (const double gap : {0.01, 0.001}) {
    CAPTURE(gap);
    const RemeshResult pair = remesh(merged(lying, plate(Vec3(1, 1, 0.03), Vec3(0, 0, 0.03 + gap))));
    check_uncut(pair);
    const MeshReport report = report_of(pair.mesh);
    CHECK(report.closed);
    CHECK(*report.volume > 0.056);
    CHECK(*report.volume < 0.062 + gap);  // where cubes can't keep them apart the gap is filled
  }
}

TEST_CASE("a body with a hole that crosses another is closed and one with it, with every preset but the paper's") {
  const PolyMesh holed = cut(ball(Vec3::Zero(), 1, 5), Vec3(0, 0, 1), 0.3).mesh;
  for (const Preset preset : {Preset::Standard, Preset::Sharp, Preset::Noisy}) {
    CAPTURE(static_cast<int>(preset));
    const RemeshResult result = remesh(merged(holed, ball(Vec3(1.5, 0, 0), 1, 5)), remesh_preset(preset));
    check_solid(result, 1, 2, two_balls(1.5));
    CHECK(result.outcomes[0].action == FillAction::Fill);
    CHECK(result.outcomes[0].new_faces > 10);
  }
}

TEST_CASE("solids of pieces that cross are the same for any number of threads") {
  const PolyMesh mesh = merged(ball(Vec3::Zero()), ball(Vec3(1.5, 0, 0)));
  RemeshOptions options;
  options.fill.threads = 1;
  const PolyMesh one = remesh(mesh, options).mesh;
  options.fill.threads = 8;
  const PolyMesh other = remesh(mesh, options).mesh;
  CHECK(one.positions == other.positions);
  CHECK(one.corners == other.corners);
}

TEST_CASE("values of vertices go over from the piece on whose surface they lie") {
  PolyMesh mesh = merged(ball(Vec3::Zero()), ball(Vec3(1.5, 0, 0)));
  std::vector<double> which(mesh.vertex_count(), 0);
  std::fill(which.begin() + static_cast<std::ptrdiff_t>(which.size() / 2), which.end(), 1);
  mesh.channels.push_back({"which", Domain::Vertex, 1, which, {}});
  const RemeshResult result = remesh(mesh);
  const auto& made = std::get<std::vector<double>>(result.mesh.channel("which", Domain::Vertex)->data);
  for (std::size_t v = 0; v < made.size(); ++v) {
    if (result.mesh.positions[v].x() < 0.7) CHECK(made[v] == 0);
    if (result.mesh.positions[v].x() > 0.8) CHECK(made[v] == Approx(1));
  }
}

TEST_CASE("however balls, rings and boxes lie in each other, nothing intersects and all is closed") {
  const int seeds = sample_count(6, 60);
  for (int seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    PolyMesh mesh;
    for (std::uint32_t left = 2 + random.below(4); left > 0; --left) {
      const Vec3 place(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      const Vec3 axis(random.between(-1, 1), random.between(-1, 1), 1);
      const std::array shapes = {round_sphere(4), ring_torus(64, 32),
                                 translated(divided_box(16), Vec3(-0.5, -0.5, -0.5))};
      const PolyMesh body = translated(
          rotated(scaled(shapes[random.below(3)], random.between(0.4, 1)), random.between(0, 6), axis.normalized()),
          place);
      mesh = merged(mesh, body);
    }
    const RemeshResult result = remesh(mesh);
    check_uncut(result);
    CHECK(report_of(result.mesh).closed);
  }
}
