// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

bool is_told(const RemeshResult& result, const char* code) {
  return std::ranges::find(result.warnings, code, &Finding::code) != result.warnings.end();
}

/// The faces of a mesh with their centres between two heights.
PolyMesh band_of(const PolyMesh& mesh, double low, double high) {
  std::vector<Index> others;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const double z = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]).z() / 3;
    if (z < low || z > high) others.push_back(f);
  }
  return without_faces(mesh, others);
}

/// A ball of edges of 0.07 in two views, one of them out of place.
PolyMesh ball_in_views(double low, double high, const Vec3& shift) {
  const PolyMesh ball = round_sphere(4);
  return merged(band_of(ball, -2, high), translated(band_of(ball, low, 2), shift));
}

double farthest_from_ball(const PolyMesh& mesh) {
  double farthest = 0;
  for (const Vec3& p : mesh.positions) farthest = std::max(farthest, std::abs(p.norm() - 1));
  return farthest;
}

}  // namespace

TEST_CASE("views that overlap or don't quite meet become one surface near to all of them") {
  for (const auto& [low, high] : {std::pair(-0.15, 0.15), std::pair(0.0, 0.0), std::pair(0.06, -0.06)}) {
    for (const Vec3& shift : {Vec3(0.03, 0, 0.01), Vec3(0, -0.02, -0.03)}) {
      CAPTURE(low, high, shift.transpose());
      const RemeshResult result = remesh(ball_in_views(low, high, shift));
      CHECK(result.checks.joined_views == 2);
      CHECK(is_told(result, "W_VIEWS_JOINED"));
      CHECK_FALSE(is_told(result, "W_OUTER_LEFT"));
      CHECK(result.checks.components == 1);
      CHECK(result.checks.open_loops == 0);
      CHECK(result.checks.self_intersections == 0);
      CHECK(farthest_from_ball(result.mesh) < 0.06);
    }
  }
}

TEST_CASE("what joined views leave open is their border, whatever rims the views have themselves") {
  const PolyMesh half = rotated(band_of(round_sphere(4), -2, 0), 0.5 * std::numbers::pi, Vec3::UnitX());
  const PolyMesh views = merged(band_of(half, -2, 0.1), translated(band_of(half, -0.1, 2), Vec3(0.01, 0.01, 0.02)));
  const RemeshResult result = remesh(views);
  CHECK(result.checks.joined_views == 2);
  CHECK(result.checks.components == 1);
  CHECK(result.checks.open_loops == 1);
  const bool is_below = half.positions[half.corners[0]].y() < 0;
  for (const Vec3& p : result.mesh.positions) CHECK((is_below ? p.y() : -p.y()) < 0.15);
}

TEST_CASE("sheets that face away from each other, or are far apart, are no views of one thing") {
  const PolyMesh half = band_of(round_sphere(4), -2, 0);
  CHECK(remesh(merged(half, flipped(scaled(half, 0.95)))).checks.joined_views == 0);
  CHECK(remesh(merged(half, translated(half, Vec3(0, 0, -0.5)))).checks.joined_views == 0);
  const PolyMesh ball = round_sphere(4);
  CHECK(remesh(merged(ball, scaled(ball, 0.97))).checks.joined_views == 0);
}

TEST_CASE("a rim at a seam that was asked for stays a hole of its own") {
  const PolyMesh views = ball_in_views(-0.15, 0.15, Vec3(0.03, 0, 0.01));
  RemeshOptions options;
  options.fill.requests.push_back({});
  options.fill.requests.back().holes = {0};
  options.fill.requests.back().fill = false;
  const RemeshResult result = remesh(views, options);
  CHECK(result.outcomes[0].action == FillAction::Leave);
}

TEST_CASE(
    "an island and the hole around it are not told as views, and what closes both is trusted by the size of the "
    "model") {
  const PolyMesh ball = round_sphere(4);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PolyMesh scan = cut_ragged(ball, Vec3(0, 0, 1), 0.3, 0.15, seed);
    const RemeshResult result = remesh(scan);
    CHECK_FALSE(is_told(result, "W_VIEWS_JOINED"));
    CHECK_FALSE(is_told(result, "W_LOW_CONFIDENCE"));
    CHECK(result.checks.open_loops == 0);
  }
}
