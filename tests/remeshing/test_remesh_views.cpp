// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/comparison.h"
#include "algorithms/remeshing/field.h"
#include "algorithms/remeshing/pieces.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

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

double volume_of(const PolyMesh& mesh) {
  double volume = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    volume += mesh.positions[face[0]].dot(mesh.positions[face[1]].cross(mesh.positions[face[2]])) / 6;
  }
  return volume;
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
      CHECK(warns(result, "W_VIEWS_JOINED"));
      CHECK_FALSE(warns(result, "W_OUTER_LEFT"));
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

TEST_CASE("a view that looks the other way is turned over, and that is reported") {
  const PolyMesh ball = round_sphere(4);
  for (const double overlap : {0.15, 0.0, -0.06}) {
    CAPTURE(overlap);
    const PolyMesh large = band_of(ball, -2, 0.3 + overlap), small = band_of(ball, 0.3 - overlap, 2);
    const PolyMesh shifted = translated(flipped(small), Vec3(0.02, 0, 0.01));
    const RemeshResult result = remesh(merged(large, shifted));
    CHECK(result.checks.turned_views == 1);
    CHECK(warns(result, "W_VIEWS_TURNED"));
    CHECK(result.checks.joined_views == 2);
    CHECK(result.checks.components == 1);
    CHECK(result.checks.open_loops == 0);
    CHECK(farthest_from_ball(result.mesh) < 0.06);
    CHECK(volume_of(result.mesh) > 3.9);
  }
}

TEST_CASE("sides of a wall stay as they are, however thin and open it is") {
  const PolyMesh half = band_of(round_sphere(4), -2, 0);  // edges of 0.07
  for (const double scale : {0.98, 0.95, 0.9}) {
    CAPTURE(scale);
    const RemeshResult result = remesh(merged(half, flipped(scaled(half, scale))));
    CHECK(result.checks.turned_views == 0);
    CHECK_FALSE(warns(result, "W_VIEWS_TURNED"));
    CHECK(result.checks.joined_views == 0);
  }
}

TEST_CASE("of views of known things those that were turned are found, and no others") {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PolyMesh scan = known_scan(ScanKind::RangeViews, seed, 12000).mesh;
    Progress progress;
    const HoleAnalysis analysis = analyse_holes(scan, progress);
    const double edge = typical_edge(scan, analysis.view);
    const ViewSeams seams = find_view_seams(scan, analysis, {}, edge);
    CAPTURE(seed);
    CHECK(seams.turned.empty());
    if (seams.joined.empty()) continue;
    ++tried;
    // The smaller one of a pair: the larger one would stay, and all others would be turned.
    const auto [first, second] = seams.joined.front();
    const std::vector<double>& areas = analysis.component_area;
    const Index turned = areas[first] < areas[second] ? first : second;
    for (std::size_t t = 0; t < analysis.view.triangles.size(); ++t)
      if (analysis.view.component[t] == turned)
        std::swap(scan.corners[3 * analysis.view.face[t]], scan.corners[3 * analysis.view.face[t] + 1]);
    const HoleAnalysis again = analyse_holes(scan, progress);
    CHECK(find_view_seams(scan, again, {}, edge).turned == std::vector<Index>{turned});
  }
  CHECK(tried > 1);
}

TEST_CASE("handles that no view has by itself are reported, of a scan of several views as it comes") {
  const auto topology = [](const PolyMesh& mesh) {
    Progress progress;
    return topology_of(mesh, 1, progress);
  };
  for (const std::uint64_t seed : {1U, 3U, 31U}) {
    const RemeshResult result = remesh(known_scan(ScanKind::RangeViews, seed).mesh);
    CAPTURE(seed);
    CHECK(warns(result, "W_VIEWS_JOINED"));
    const bool is_ball =
        topology(result.mesh) ==
        SurfaceTopology{result.checks.components, 2 * static_cast<std::int64_t>(result.checks.components)};
    CHECK(is_ball == (seed != 1));  // the first is closed with two handles that the thing hasn't
    CHECK(warns(result, "W_SHAPE_DIFFERS") == !is_ball);
  }
}

TEST_CASE("what a piece's sheets imply is known although they share vertices or edges") {
  const auto implied = [](const PolyMesh& scan) {
    Progress progress;
    const HoleAnalysis analysis = analyse_holes(scan, progress);
    RemeshPiece piece;
    for (Index v = 0; v < scan.vertex_count(); ++v) piece.vertices.push_back(v);
    for (Index t = 0; t < analysis.view.triangles.size(); ++t) piece.triangles.push_back(t);
    std::vector<Index> corners;
    for (const auto& triangle : analysis.view.triangles)
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    const TriangleFans fans(scan.vertex_count(), corners);
    return expected_topology(analysis, piece, fans.links(1, progress));
  };
  const PolyMesh ball = round_sphere(3), ring = torus(24, 12);
  CHECK(implied(ball)->topology == SurfaceTopology{1, 2});
  CHECK(implied(ring)->topology == SurfaceTopology{1, 0});
  CHECK(implied(merged(ball, translated(ball, Vec3(1, 0, 0))))->topology == SurfaceTopology{1, 2});
  CHECK(implied(merged(ring, translated(ring, Vec3(9, 0, 0))))->topology == SurfaceTopology{1, -2});
  const auto shared = [&](Index f) {
    return std::ranges::count_if(ring.face(f),
                                 [&](Index v) { return std::ranges::find(ring.face(0), v) != ring.face(0).end(); });
  };
  Index other = 1;
  while (shared(other) != 1) ++other;
  const PolyMesh pinched = without_faces(ring, std::vector<Index>{0, other});  // two holes that share a vertex
  CHECK(implied(pinched)->topology == SurfaceTopology{1, 0});
  CHECK(implied(ring)->is_clear);
  CHECK_FALSE(implied(pinched)->is_clear);
}

TEST_CASE("of views the minority by area is turned, by their strongest pairs") {
  const std::vector<double> areas = {1, 4, 1, 3, 3};
  CHECK(minority_of({{0, 1, 20, true}, {1, 2, 20, false}}, areas) == std::vector<Index>{0});
  CHECK(minority_of({{0, 1, 20, true}, {0, 2, 20, false}}, areas) == std::vector<Index>{0, 2});
  CHECK(minority_of({{0, 1, 20, true}, {1, 2, 30, false}, {0, 2, 10, false}}, areas) == std::vector<Index>{0});
  CHECK(minority_of({{3, 4, 20, true}}, areas) == std::vector<Index>{4});
  CHECK(minority_of({{3, 4, 20, false}}, areas).empty());
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
    "an island and the hole around it are not reported as views, and what closes both is trusted by the size of the "
    "model") {
  const PolyMesh ball = round_sphere(4);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PolyMesh scan = cut_ragged(ball, Vec3(0, 0, 1), 0.3, 0.15, seed);
    const RemeshResult result = remesh(scan);
    CHECK_FALSE(warns(result, "W_VIEWS_JOINED"));
    CHECK_FALSE(warns(result, "W_LOW_CONFIDENCE"));
    CHECK(result.checks.open_loops == 0);
  }
}
