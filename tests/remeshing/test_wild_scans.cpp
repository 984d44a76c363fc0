// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/backing.h"
#include "algorithms/remeshing/comparison.h"
#include "algorithms/remeshing/memory.h"
#include "algorithms/remeshing/united_solid.h"
#include "croquis/base/error.h"
#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/sample_count.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"
#include "support/scans/wild_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

bool warns_of_any(const Findings& findings, std::span<const char* const> codes) {
  return std::ranges::any_of(
      findings, [&](const Finding& finding) { return std::ranges::find(codes, finding.code) != codes.end(); });
}

/// Nothing when the scan was refused as a whole, with a sentence.
std::optional<RemeshResult> remeshed_or_refused(const PolyMesh& scan, const RemeshOptions& options) {
  try {
    return remesh(scan, options);
  } catch (const Error& error) {
    CHECK(error.findings().front().code == "E_NOT_REMESHED");
    CHECK(error.findings().front().category == Category::Geometry);
    return std::nullopt;
  }
}

/// Vertices that are farther from the scan's triangles than so much, in no reach of a hole that was closed: patches
/// go 1.5 diameters at most.
std::size_t unexplained(const PolyMesh& scan, const RemeshResult& result, double far) {
  const SurfaceDistance to_scan(scan);
  std::size_t count = 0;
  for (const Vec3& place : result.mesh.positions) {
    if (to_scan(place) <= far) continue;
    const bool is_in_hole = std::ranges::any_of(result.analysis.holes, [&](const Hole& hole) {
      if (result.outcomes[hole.id].action != FillAction::Fill) return false;
      const double reach = result.outcomes[hole.id].method == "remesh" ? 0.8 : 1.5;
      return std::ranges::any_of(hole.vertices,
                                 [&](Index v) { return (scan.positions[v] - place).norm() <= reach * hole.diameter; });
    });
    if (!is_in_hole) ++count;
  }
  return count;
}

/// Share of the scan's area that has nothing within three edges.
double missing_share(const PolyMesh& scan, const RemeshResult& result) {
  std::vector<Index> faces(scan.face_count());
  for (Index f = 0; f < faces.size(); ++f) faces[f] = f;
  const std::vector<Vec3> samples = sample_faces(scan, faces, 3000);
  const SurfaceDistance to_result(result.mesh);
  const double far = 3 * mean_edge_of(scan);
  const auto missing = std::ranges::count_if(samples, [&](const Vec3& place) { return to_result(place) > far; });
  return static_cast<double>(missing) / static_cast<double>(samples.size());
}

}  // namespace

TEST_CASE("scans as wild as they come are remeshed near to what they are, or refused with a reason") {
  constexpr std::array losses = {"W_PIECE_REFUSED", "W_PIECE_LOST", "W_DETAIL_LOST", "W_NOT_CLOSED"};
  const auto seeds = static_cast<std::uint64_t>(sample_count(2, 20));
  std::size_t made = 0, all = 0;
  for (const WildScan kind : all_wild_scans) {
    for (std::uint64_t seed = 101; seed < 101 + seeds; ++seed) {
      CAPTURE(name_of(kind), seed);
      const PolyMesh scan = wild_scan(kind, seed, 3000);
      const auto result = remeshed_or_refused(scan, {});
      ++all;
      if (!result) continue;
      ++made;
      CHECK(unexplained(scan, *result, 4 * mean_edge_of(scan)) == 0);
      if (missing_share(scan, *result) > 0.1) CHECK(warns_of_any(result->warnings, losses));
      CHECK(result->checks.manifold);
      CHECK((result->checks.self_intersections == 0 || warns(*result, "W_CUTS_ITSELF")));
    }
  }
  CHECK(4 * made > 3 * all);  // refusing isn't the cure
}

TEST_CASE("but in holes nothing lies farther than half a cell off a scan, or it is reported") {
  const std::array kinds = {ScanKind::RangeView, ScanKind::Face, ScanKind::Statue, ScanKind::Photogrammetry};
  for (const ScanKind kind : kinds) {
    for (const std::uint64_t seed : {1U, 3U}) {
      const PolyMesh scan = known_scan(kind, seed, 5000).mesh;
      const RemeshResult result = remesh(scan);
      CAPTURE(name_of(kind), seed, result.checks.loose_points);
      const double cell = std::min(mean_edge_of(scan), diagonal_of(scan) / 40);
      CHECK(unexplained(scan, result, 0.5 * cell) <= result.checks.loose_points);
      CHECK(warns(result, "W_OFF_SCAN") == (result.checks.loose_points > 0));
      CHECK(200 * result.checks.loose_points < result.mesh.vertex_count());
    }
  }
}

TEST_CASE("what is a little off the scan is brought near, but where it would cut through something") {
  PolyMesh surface = round_sphere(3);  // edges of 0.15
  Progress progress;
  std::vector<LooseVertex> loose;
  for (const Index v : {Index{3}, Index{100}, Index{200}}) {
    const Vec3 foot = surface.positions[v];
    surface.positions[v] *= 1.3;
    loose.push_back({v, foot, 0.3});
  }
  PolyMesh crossed = merged(surface, translated(scaled(round_sphere(1), 0.01), 1.15 * loose[1].foot));
  bring_near(surface, loose, 0.1, Precision::Double, progress);
  CHECK(loose.empty());
  for (const Index v : {Index{3}, Index{100}, Index{200}})
    CHECK(surface.positions[v].norm() == Approx(1.09).margin(1e-9));

  loose = {{3, round_sphere(3).positions[3], 0.3}, {100, round_sphere(3).positions[100], 0.3}};
  // The small ball lies in the spike; the spike would leave it outside only by passing through it.
  const std::vector<Vec3> before = crossed.positions;
  bring_near(crossed, loose, 0.15 / 0.9, Precision::Double, progress);
  REQUIRE(loose.size() == 1);
  CHECK(loose[0].vertex == 100);
  CHECK(crossed.positions[100] == before[100]);
  CHECK(crossed.positions[3].norm() == Approx(1.15).margin(1e-9));
}

TEST_CASE("boxes and volumes that differ are found, whatever closes holes is allowed for") {
  const PolyMesh ball = round_sphere(4);
  Progress progress;
  const auto change = [&](const PolyMesh& scan, const PolyMesh& made) {
    const HoleAnalysis analysis = analyse_holes(scan, progress);
    RemeshPiece piece;
    for (Index v = 0; v < scan.vertex_count(); ++v) piece.vertices.push_back(v);
    for (Index t = 0; t < analysis.view.triangles.size(); ++t) piece.triangles.push_back(t);
    for (const Hole& hole : analysis.holes) piece.groups.push_back({hole.id});
    return change_of(extent_of_scan(scan, analysis, piece), extent_of_surface(made, true), analysis, piece, 0.07);
  };
  CHECK_FALSE(change(ball, ball).any());
  CHECK_FALSE(change(ball, scaled(ball, 1.01)).any());
  const ExtentChange larger = change(ball, scaled(ball, 1.2));
  CHECK(larger.given == Approx(4.18).margin(0.02));
  CHECK(larger.made == Approx(1.728 * larger.given));
  CHECK(larger.grown == Approx(0.2).margin(0.01));
  CHECK(larger.shrunk == 0);
  CHECK(change(ball, scaled(ball, 0.8)).shrunk == Approx(0.2).margin(0.01));
  CHECK(change(ball, flipped(ball)).made < 0);
  CHECK_FALSE(change(without_loose_vertices(cut(ball, Vec3(0, 0, 1), 0.4).mesh), ball).any());
}

TEST_CASE("a solid of several pieces encloses no less than one of them and no more than all") {
  const PolyMesh ball = round_sphere(4);
  const double volume = *extent_of_surface(ball, true).volume;
  const auto differs = [&](const PolyMesh& solid, const std::vector<std::optional<double>>& volumes) {
    return change_of_solid(volumes, solid, 0.07).any();
  };
  CHECK_FALSE(differs(ball, {volume, volume}));
  CHECK_FALSE(differs(ball, {volume, 0.1 * volume}));
  CHECK_FALSE(differs(scaled(ball, 1.2), {volume, volume}));
  CHECK(differs(scaled(ball, 1.4), {volume, volume}));
  CHECK(differs(scaled(ball, 0.8), {volume, volume}));
  CHECK_FALSE(differs(scaled(ball, 0.8), {volume, -0.5 * volume}));  // a cavity
  CHECK(differs(scaled(ball, 1.2), {volume, -0.5 * volume}));
  CHECK_FALSE(differs(scaled(ball, 1.4), {volume, std::nullopt}));  // has rims
  CHECK_FALSE(differs(scaled(ball, 0.9), {volume}));                // crossed itself
  CHECK(differs(scaled(ball, 0.6), {volume}));
}

TEST_CASE("in a hole's reach only what leaves the scan along its rim closes it") {
  const PolyMesh ball = round_sphere(4);
  const PolyMesh scan = without_loose_vertices(cut(ball, Vec3(0, 0, 1), 0.4).mesh);  // radius of the hole
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(scan, progress);
  REQUIRE(analysis.holes.size() == 1);
  RemeshPiece piece;
  for (Index v = 0; v < scan.vertex_count(); ++v) piece.vertices.push_back(v);
  for (Index t = 0; t < analysis.view.triangles.size(); ++t) piece.triangles.push_back(t);
  piece.groups = {{0}};
  const TriangleFans fans(scan.vertex_count(), scan.corners);
  const RemeshPoints points = points_of(scan, analysis, piece, scan.positions, 0.07);
  const NearestScan given(scan, analysis.view, fans, piece, points, 1);
  const auto unbacked_in = [&](const PolyMesh& surface, const std::vector<Index>& open) {
    const HoleReach holes(scan, analysis, piece, {}, {}, 0.07, open);
    return find_unbacked(surface, given, holes, 0.05, 0.1, progress);
  };
  CHECK(unbacked_in(ball, {}).far_count == 0);
  CHECK(unbacked_in(ball, {0}).far_count > 0);  // a hole that stays open is no excuse
  const PolyMesh bubble = translated(scaled(round_sphere(2), 0.08), 1.2 * Vec3(std::sin(0.7), 0, std::cos(0.7)));
  const HoleReach holes(scan, analysis, piece, {}, {}, 0.07, {});
  REQUIRE(std::ranges::all_of(bubble.positions, [&](const Vec3& place) { return holes.contains(place); }));
  const UnbackedVertices found = unbacked_in(merged(ball, bubble), {});
  CHECK(found.far_count == bubble.vertex_count());
  CHECK(std::count(found.is_far.begin(), found.is_far.begin() + static_cast<std::ptrdiff_t>(ball.vertex_count()), 1) ==
        0);
}

TEST_CASE(
    "surface where no scan is near is counted, and reported from a hundredth of all on, with its share and a place") {
  constexpr std::array kinds = {ScanKind::RangeViews, ScanKind::Pot, ScanKind::Part, ScanKind::Thorns};
  std::size_t far_ones = 0;
  for (const ScanKind kind : kinds) {
    for (const std::uint64_t seed : {1U, 3U}) {
      const KnownScan known = known_scan(kind, seed, 5000);
      const RemeshResult result = remesh(known.mesh);
      CAPTURE(name_of(kind), seed);
      const SurfaceDistance to_scan(known.mesh);
      const double far = 0.05 * diagonal_of(known.mesh);
      const auto count = static_cast<std::size_t>(
          std::ranges::count_if(result.mesh.positions, [&](const Vec3& place) { return to_scan(place) > far; }));
      CHECK(result.checks.far_points == count);
      CHECK(warns(result, "W_FAR_FROM_SCAN") == (result.checks.far_share >= 0.01));
      CHECK((result.checks.far_share > 0) == (count > 0));
      far_ones += warns(result, "W_FAR_FROM_SCAN") ? 1U : 0U;
      const auto warning = std::ranges::find(result.warnings, "W_FAR_FROM_SCAN", &Finding::code);
      if (warning == result.warnings.end()) continue;
      REQUIRE(warning->subjects.size() == 1);
      const std::vector<double>& at = warning->subjects[0].at;
      CHECK(to_scan(Vec3(at[0], at[1], at[2])) > far);
    }
  }
  CHECK(far_ones > 2);
  CHECK(far_ones < 8);
}

TEST_CASE("the end of what views saw gets a flat lid, what closes in on itself is continued") {
  const auto astray_share = [](const KnownScan& known, const PolyMesh& made) {
    const SurfaceDistance to_scan(known.mesh), to_thing(known.truth);
    const double far = 0.05 * known.diagonal;
    const auto astray = std::ranges::count_if(
        made.positions, [&](const Vec3& place) { return to_scan(place) > far && to_thing(place) > far; });
    return static_cast<double>(astray) / static_cast<double>(made.vertex_count());
  };
  const KnownScan figure = known_scan(ScanKind::RangeViews, 9);  // its base: 0.078 by a patch that bulged out of it
  CHECK(astray_share(figure, remesh(figure.mesh).mesh) < 0.005);
  const KnownScan round = known_scan(ScanKind::RangeViews, 51);  // no view saw its end
  const RemeshResult made = remesh(round.mesh);
  CHECK(astray_share(round, made.mesh) < 0.005);
  const SurfaceDistance to_made(made.mesh);
  for (const KnownHole& hole : round.holes)
    CHECK(summary_of_distances(hole.places, to_made).mean < 0.01 * round.diagonal);
}

TEST_CASE("where the field leads far away the holes are left to patches, and the rest is remeshed") {
  const PolyMesh scan = wild_scan(WildScan::Monument, 4, 8000);
  const RemeshResult result = remesh(scan);
  CHECK(unexplained(scan, result, 4 * mean_edge_of(scan)) == 0);
  CHECK(result.mesh.face_count() < 2 * scan.face_count());
  CHECK(diagonal_of(result.mesh) < 1.05 * diagonal_of(scan));
}

TEST_CASE("where the field leaves a hole open the model is made once more, and no third time") {
  const KnownScan known = known_scan(ScanKind::Photogrammetry, 1);
  std::size_t fits = 0;
  std::string last;
  Progress progress([&](double, const std::string& step) {
    fits += step == "fit functions" && last != step ? 1U : 0U;
    last = step;
  });
  CHECK(remesh_surface(known.mesh, {}, progress).checks.manifold);
  CHECK(fits <= 20);  // over all pieces; 22 when boxes were made larger first
}

TEST_CASE("wide holes are closed by what lies around each of them alone, however near others are") {
  const KnownScan known = known_scan(ScanKind::Bones, 201);  // a limb's end is missing, beside holes bent around it
  const RemeshResult result = remesh(known.mesh);
  const SurfaceDistance to_thing(known.truth);
  const auto astray = std::ranges::count_if(result.mesh.positions,
                                            [&](const Vec3& place) { return to_thing(place) > 0.05 * known.diagonal; });
  CHECK(500 * static_cast<std::size_t>(astray) < result.mesh.vertex_count());
  CHECK(std::ranges::any_of(result.outcomes,
                            [](const HoleOutcome& outcome) { return outcome.method == "implicit-cubes"; }));
}

TEST_CASE("of sheets that cross and have no inside the larger one is remeshed, and the other one is named") {
  const PolyMesh large = translated(sheet(30, 30), Vec3(-14.6, -14.7, 0.1));
  const PolyMesh small = rotated(translated(sheet(26, 26), Vec3(-13, -13, 0)), 1.2, Vec3(1, 0.2, 0).normalized());
  const RemeshResult result = remesh(merged(small, large));
  REQUIRE(warns(result, "W_PIECE_REFUSED"));
  CHECK(result.checks.self_intersections == 0);
  CHECK(summary_of_distances(large.positions, SurfaceDistance(result.mesh)).greatest < 1.5);
  CHECK(summary_of_distances(result.mesh.positions, SurfaceDistance(large)).greatest < 0.5);
  const auto warning = std::ranges::find(result.warnings, "W_PIECE_REFUSED", &Finding::code);
  CHECK(warning->message.find("Piece 0") != std::string::npos);
  REQUIRE(warning->subjects.size() == 1);
  CHECK(warning->subjects[0].at.size() == 3);
}

TEST_CASE("a piece of which most gets lost is left out with its share, alone it is an error") {
  const PolyMesh plate = transformed(divided_box(36), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 0.15 / 36)));
  RemeshOptions options;
  CHECK_FALSE(remeshed_or_refused(plate, options).has_value());
  const PolyMesh ball = translated(round_sphere(4), Vec3(3, 0, 0));
  options.memory_limit = least_remesh_bytes(merged(plate, ball), options);
  const RemeshResult both = remesh(merged(plate, ball), options);
  constexpr std::array codes = {"W_PIECE_REFUSED", "W_PIECE_LOST"};
  CHECK(warns_of_any(both.warnings, codes));
  CHECK(summary_of_distances(both.mesh.positions, SurfaceDistance(ball)).greatest < 0.02);
  CHECK(summary_of_distances(ball.positions, SurfaceDistance(both.mesh)).greatest < 0.02);
}

TEST_CASE("a closed surface goes once round what it encloses, half of one half round its middle") {
  const auto times_round = [](const PolyMesh& mesh, const Vec3& place) {
    return SignedSurface(mesh, Progress()).winding_number(place);
  };
  CHECK(times_round(round_sphere(3), Vec3(0.3, 0.2, 0.1)) == Approx(1));
  CHECK(times_round(flipped(round_sphere(3)), Vec3(0.3, 0.2, 0.1)) == Approx(-1));
  CHECK(times_round(round_sphere(3), Vec3(2, 0, 0)) == Approx(0).margin(1e-12));
  CHECK(std::abs(times_round(bowl(48, 20), Vec3::Zero())) == Approx(0.5).margin(0.01));
}
