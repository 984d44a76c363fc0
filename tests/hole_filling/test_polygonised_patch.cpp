// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "algorithms/hole_filling/patching/sheet_loops.h"
#include "algorithms/hole_filling/verification/patch_verification.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"
#include "support/scans/sculptures.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// A hole with its companions each.
std::vector<std::vector<Index>> groups_of(const HoleAnalysis& analysis) {
  DisjointSets groups(analysis.holes.size());
  for (const Hole& hole : analysis.holes) {
    for (const Index other : hole.companions) groups.unite(hole.id, other);
  }
  return groups.lists();
}

std::optional<HolePatch> by_cubes(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<Index>& holes) {
  Progress progress;
  return cubes_patch(make_site(mesh, analysis, holes, {}), false, progress);
}

struct Tally {
  std::size_t sites = 0, made = 0, sound = 0;
};

/// Patches by cubes alone, each through the door that leads into meshes.
Tally tally(const PolyMesh& mesh) {
  const HoleAnalysis analysis = analysis_of(mesh);
  PatchVerifier verifier(mesh, analysis);
  Progress progress;
  Tally result;
  for (const std::vector<Index>& group : groups_of(analysis)) {
    ++result.sites;
    const auto patch = by_cubes(mesh, analysis, group);
    if (!patch || !patch->arrives_at.empty()) continue;
    ++result.made;
    result.sound += verifier.accept_sound(std::vector{*patch}, progress)[0].is_sound() ? 1U : 0U;
  }
  return result;
}

PolyMesh without(const PolyMesh& mesh, const std::function<bool(const Vec3&)>& is_gone) {
  std::vector<Index> gone;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (std::ranges::all_of(mesh.face(f), [&](Index v) { return is_gone(mesh.positions[v]); })) gone.push_back(f);
  }
  return without_faces(mesh, gone);
}

void check_one_sphere(const FillResult& result) {
  const MeshReport report = report_of(result.mesh);
  CHECK(report.components == 1);
  CHECK(report.closed);
  CHECK(report.genus == 0);
  CHECK(*report.self_intersections == 0);
  for (const HoleOutcome& outcome : result.outcomes) CHECK(outcome.method == "implicit-cubes");
}

/// Counter-clockwise about z.
std::vector<Vec3> circle(double radius, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return points;
}

ZipSides sides_of(std::vector<Vec3> left, std::vector<Vec3> right) {
  ZipSides sides{std::move(left), std::move(right), {}, {}};
  sides.left_normals.assign(sides.left.size(), Vec3::UnitZ());
  sides.right_normals.assign(sides.right.size(), Vec3::UnitZ());
  return sides;
}

}  // namespace

TEST_CASE("a piece in a hole that looks like a border is closed with it where the surface around arrives there") {
  const KnownScan scan =
      known_scan(ScanKind::Face, 5);  // open at the back; a hole with two islands, one beside its rim
  const auto open_borders = [&](const FillOptions& options) {
    const FillResult result = fill(scan.mesh, options);
    CHECK(begins_with(result.mesh, scan.mesh));
    return std::ranges::count(result.outcomes, FillAction::Leave, &HoleOutcome::action);
  };
  CHECK(open_borders({}) == 1);
  FillOptions island_stays;
  HoleRequest& stays = island_stays.requests.emplace_back();
  stays.fill = false;
  const HoleAnalysis analysis = analysis_of(scan.mesh);
  const auto border = [&](const Hole& hole) { return hole.kind == HoleClass::Outer && hole.vertices.size() < 20; };
  REQUIRE(std::ranges::count_if(analysis.holes, border) == 1);
  stays.holes = {std::ranges::find_if(analysis.holes, border)->id};
  CHECK(open_borders(island_stays) == 2);
}

TEST_CASE("a wide hole in one skin of a wall is closed clear of the other skin, where what goes straight on cuts it") {
  const KnownScan scan = known_scan(ScanKind::Pot, 35);
  const FillResult result = fill(scan.mesh);
  CHECK(filled_by(result, "implicit-cubes-careful") == 1);
  Progress progress;
  CHECK(find_self_intersections(result.mesh, progress).count == 0);
}

TEST_CASE("patches by cubes alone are sound over random cuts, and none is missing") {
  const std::vector<PolyMesh> shapes = {round_sphere(5), ring_torus(120, 60), triangulated(uv_sphere(80, 60)),
                                        triangulated(bust(80, 100))};
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(2, 20)); ++seed) {
    for (const PolyMesh& shape : shapes) {
      const CutScan scan = random_cuts(shape, seed, 4, 0.12, 0.4);
      const HoleAnalysis analysis = analysis_of(scan.mesh);
      PatchVerifier verifier(scan.mesh, analysis);
      Progress progress;
      for (const Hole& hole : analysis.holes) {
        if (hole.kind == HoleClass::Outer) continue;
        const auto patch = by_cubes(scan.mesh, analysis, {hole.id});
        CAPTURE(seed, shape.vertex_count(), hole.id, hole.vertices.size());
        REQUIRE(patch);
        CHECK(verifier.accept_sound(std::vector{*patch}, progress)[0].fault.empty());
      }
    }
  }
}

TEST_CASE("a patch by cubes comes to rest where the field is nearly flat") {
  const PolyMesh mesh = random_cuts(triangulated(bust(80, 100)), 4, 4, 0.12, 0.4).mesh;
  const HoleAnalysis analysis = analysis_of(mesh);
  const auto patch = by_cubes(mesh, analysis, {2});
  REQUIRE(patch);
  Progress progress;
  CHECK(PatchVerifier(mesh, analysis).accept_sound(std::vector{*patch}, progress)[0].is_sound());
}

TEST_CASE("the corner of a box comes back by cubes though curvature continued runs away from it") {
  const PolyMesh box = triangulated(divided_box(40));
  Vec3 corner = box.positions.front();
  for (const Vec3& p : box.positions) corner = corner.cwiseMax(p);
  const PolyMesh mesh = cut(box, corner, 0.3).mesh;
  const HoleAnalysis analysis = analysis_of(mesh);
  const auto patch = by_cubes(mesh, analysis, {0});
  REQUIRE(patch);
  Progress progress;
  CHECK(PatchVerifier(mesh, analysis).accept_sound(std::vector{*patch}, progress)[0].is_sound());
  for (const Vec3& p : patch->points) CHECK((p - corner).norm() < 0.35);
}

TEST_CASE("huge ragged holes of sculptures get sound patches by cubes, or none") {
  Tally total;
  for (const Sculpture sculpture : {Sculpture::Beast, Sculpture::Hand, Sculpture::Knot}) {
    const PolyMesh whole = sculpt(sculpture, 12000);
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sample_count(2, 10)); ++seed) {
      const Tally tried =
          tally(ragged_cuts(whole, {.seed = seed, .count = 1, .low = 0.12, .high = 0.2, .raggedness = 0.3}).mesh);
      total.sites += tried.sites;
      total.made += tried.made;
      total.sound += tried.sound;
    }
  }
  CAPTURE(total.sites, total.made);
  CHECK(total.sound == total.made);
  CHECK(4 * total.sound >= 3 * total.sites);
}

TEST_CASE("a hole and its islands become one sphere by cubes") {
  const PolyMesh ball = round_sphere(5);
  check_one_sphere(fill(cut_ring(ball, Vec3(0, 0.6, 0.8), 0.25, 0.6).mesh, everything()));
  const PolyMesh two = without(ball, [](const Vec3& p) {
    return (p - Vec3(0, 0, 1)).norm() < 0.8 && (p - Vec3(0.4, 0, 0.92)).norm() > 0.15 &&
           (p - Vec3(-0.4, 0, 0.92)).norm() > 0.15;
  });
  const FillResult result = fill(two, everything());
  REQUIRE(result.outcomes.size() == 3);
  check_one_sphere(result);
  CHECK(greatest_radial_error(result) < 0.003);
}

TEST_CASE("a continuation that comes upon another rim names it, and both are filled together") {
  // The wider rim is taken for a border, the piece beyond it therefore not for an island.
  const PolyMesh mesh = without(round_sphere(4), [](const Vec3& p) { return p.z() > 0.2 && p.z() < 0.95; });
  const HoleAnalysis analysis = analysis_of(mesh);
  REQUIRE(analysis.holes.size() == 2);
  REQUIRE(analysis.holes[0].companions.empty());
  std::vector<std::vector<Index>> arrivals;
  for (const Index hole : {0U, 1U}) {
    const auto patch = by_cubes(mesh, analysis, {hole});
    if (!patch) continue;
    arrivals.push_back(patch->arrives_at);
    CHECK(patch->arrives_at == std::vector<Index>{1 - hole});
    CHECK(patch->triangles.empty());
  }
  CHECK_FALSE(arrivals.empty());
  check_one_sphere(fill(mesh, everything()));
}

TEST_CASE("continuations that don't close come to nothing, soon") {
  PolyMesh saddle = sheet(20, 20), slope = sheet(20, 20);
  for (Vec3& p : saddle.positions) p.z() = 0.02 * (p.x() - 10) * (p.y() - 10);
  for (Vec3& p : slope.positions) p = Vec3(p.x() + 1e5, 0.6 * p.y(), 0.8 * p.y());
  const PolyMesh half_plane = without(sheet(40, 40), [](const Vec3& p) { return p.x() > 19.5 || p.y() > 30.5; });
  for (const PolyMesh& mesh : {sheet(20, 20), saddle, slope, half_plane}) {
    const HoleAnalysis analysis = analysis_of(mesh);
    REQUIRE(analysis.holes.size() == 1);
    CHECK_FALSE(by_cubes(mesh, analysis, {0}));
  }
}

TEST_CASE("both skins of a thin shell are continued each by itself") {
  for (const double wall : {0.03, 0.06, 0.1}) {
    const PolyMesh whole = shell(4, wall);
    const PolyMesh mesh = cut(cut(whole, Vec3(0, 0, 1), 0.3).mesh, Vec3(0, 0, 1 - wall), 0.3).mesh;
    const HoleAnalysis analysis = analysis_of(mesh);
    REQUIRE(analysis.holes.size() == 2);
    PatchVerifier verifier(mesh, analysis);
    Progress progress;
    for (const Hole& hole : analysis.holes) {
      INFO(wall);
      const auto patch = by_cubes(mesh, analysis, {hole.id});
      REQUIRE(patch);
      CHECK(patch->arrives_at.empty());
      CHECK(verifier.accept_sound(std::vector{*patch}, progress)[0].fault.empty());
      const double radius = mesh.positions[hole.vertices.front()].norm();
      for (const Vec3& p : patch->points) CHECK(std::abs(p.norm() - radius) < 0.001);
    }
  }
}

TEST_CASE("a strip between circles has a triangle for each of their edges and their area") {
  Progress progress;
  for (const std::size_t count : {7U, 20U, 33U, 3000U}) {
    const auto strip = zip(sides_of(circle(1, 24), circle(0.8, count)), progress);
    REQUIRE(strip);
    CHECK(strip->size() == 24 + count);
  }
  const auto strip = zip(sides_of(circle(1, 64), circle(0.8, 50)), progress);
  REQUIRE(strip);
  PolyMesh mesh;
  for (const auto& points : {circle(1, 64), circle(0.8, 50)})
    mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
  double area = 0;
  for (const auto& [a, b, c] : *strip) {
    mesh.add_triangle(a, b, c);
    const Vec3 ab = mesh.positions[b] - mesh.positions[a], ac = mesh.positions[c] - mesh.positions[a];
    CHECK(ab.cross(ac).z() > 0);
    area += ab.cross(ac).z() / 2;
  }
  const auto polygon = [](double radius, double n) {
    return n / 2 * radius * radius * std::sin(2 * std::numbers::pi / n);
  };
  CHECK(area == Approx(polygon(1, 64) - polygon(0.8, 50)));
  CHECK(MeshTopology(mesh).boundary_loops().size() == 2);
}

TEST_CASE("a strip between sides that run against each other isn't made") {
  Progress progress;
  std::vector<Vec3> against = circle(0.8, 30);
  std::reverse(against.begin(), against.end());
  CHECK_FALSE(zip(sides_of(circle(1, 30), against), progress));
}

TEST_CASE("places on the surface around a hole are covered, those beyond its rim or on the other skin aren't") {
  const PolyMesh mesh = cut(shell(4, 0.2), Vec3(0, 0, 1), 0.5).mesh;
  const HoleAnalysis analysis = analysis_of(mesh);
  REQUIRE(analysis.holes.size() == 1);
  const HoleSite site = make_site(mesh, analysis, std::vector<Index>{0}, {});
  const Covering covering(site, {Vec3::Constant(-2), Vec3::Constant(2)});
  const auto surface = fit_rims(site, {});
  REQUIRE(surface);
  const double cell = surface->edge;
  std::vector<Vec3> places;
  for (const double angle : {0.0, 0.1, 0.25, 0.7, 1.0}) places.emplace_back(std::sin(angle), 0, std::cos(angle));
  std::vector<std::uint8_t> covered(places.size());
  covering.mark(surface->field(), cell, places, covered);
  CHECK(covered == std::vector<std::uint8_t>{0, 0, 0, 1, 1});
  CHECK(covering.wall(1) == Approx(0.2).epsilon(0.1));
  CHECK(covering.wall(0.1) == 0.1);
}

TEST_CASE("whatever is left out of a sheet, simple borders are left") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const PolyMesh mesh = seed % 2 == 0 ? sheet(15, 15) : round_sphere(3);
    Random random(seed);
    std::vector<std::uint8_t> left_out(mesh.vertex_count());
    for (std::uint8_t& out : left_out) out = random.unit() < 0.02 * static_cast<double>(seed % 8) ? 1 : 0;
    const PolyMesh open = open_sheet(mesh, left_out);
    const MeshTopology topology(open);
    for (Index v = 0; v < open.vertex_count(); ++v) CHECK(topology.fan_count(v) == 1);
    for (Index f = 0; f < open.face_count(); ++f) {
      int border_edges = 0;
      for (Index corner = 3 * f; corner < 3 * f + 3; ++corner)
        border_edges += topology.opposite(corner) == no_index ? 1 : 0;
      CHECK(border_edges < 2);
    }
    CHECK(open_sheet(open, std::vector<std::uint8_t>(open.vertex_count(), 0)).corners == open.corners);
  }
}
