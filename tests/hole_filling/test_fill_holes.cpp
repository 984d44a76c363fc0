// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_choice.h"
#include "hole_filling/fill_invariants.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

constexpr Fairness all_fairness[] = {Fairness::Flat, Fairness::Tangent, Fairness::Implicit};

std::vector<std::string> codes_of(const FillResult& result) {
  std::vector<std::string> codes;
  for (const Finding& finding : result.warnings) codes.push_back(finding.code);
  return codes;
}

}  // namespace

TEST_CASE("random cuts are closed soundly, by every fairness, on every shape") {
  const std::vector<std::pair<PolyMesh, double>> shapes = {
      {round_sphere(4), 1}, {ring_torus(60, 30), 1}, {divided_box(16), 0.6}, {uv_sphere(40, 30), 1},
      {torus(50, 24), 1},   {bust(60, 70), 0.6},     {sheet(20, 20), 8}};
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(2, 40)); ++seed) {
    for (const auto& [shape, size] : shapes) {
      const CutScan scan = random_cuts(shape, seed, 1 + seed % 4, 0.12 * size, 0.3 * size);
      for (const Fairness fairness : all_fairness) {
        const FillResult result = fill(scan.mesh, by(fairness));
        check_invariants(scan.mesh, result);
        for (std::size_t i = 0; i < result.outcomes.size(); ++i)
          CHECK((result.outcomes[i].action == FillAction::Fill) == (result.analysis.holes[i].kind != HoleClass::Outer));
      }
    }
  }
}

TEST_CASE("soups of any kind are filled soundly where they can be") {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(60, 1000)); ++seed) {
    Random random(seed);
    PolyMesh mesh;
    const Index vertices = 5 + random.below(25);
    for (Index v = 0; v < vertices; ++v) {
      const double x = random.unit(), y = random.unit();
      mesh.positions.emplace_back(x, y, random.unit());
    }
    const Index triangles = 2 + random.below(30);
    while (mesh.face_count() < triangles) {
      const Index a = random.below(vertices), b = random.below(vertices), c = random.below(vertices);
      if (a != b && b != c && c != a) mesh.add_triangle(a, b, c);
    }
    FillOptions options;
    options.selection = Selection::All;
    options.fairness = all_fairness[seed % 4];
    check_invariants(mesh, fill(mesh, options));
  }
}

TEST_CASE("surfaces with faces missing at random are filled soundly where they can be") {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(9, 100)); ++seed) {
    Random random(seed);
    const PolyMesh whole = seed % 2 == 0 ? round_sphere(3) : ring_torus(24, 12);
    std::vector<Index> missing;
    for (Index f = 0; f < whole.face_count(); ++f) {
      if (random.unit() < 0.05 + 0.02 * static_cast<double>(seed % 5)) missing.push_back(f);
    }
    FillOptions options;
    options.selection = Selection::All;
    options.fairness = all_fairness[seed % 4];
    const PolyMesh mesh = without_faces(whole, missing);
    const FillResult result = fill(mesh, options);
    check_invariants(mesh, result);
    CHECK(10 * filled(result) > 9 * result.outcomes.size());
  }
}

TEST_CASE("a rim around a fin is filled without cutting the fin") {
  // The least area spans the hole flat, and a fin that is part of the rim stands in its way.
  PolyMesh mesh = without_faces(sheet(9, 9), std::vector<Index>{});
  mesh = cut(mesh, Vec3(4.5, 4.5, 0), 2.6).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  REQUIRE(analysis.holes.size() == 2);
  const auto& rim = analysis.holes[1].vertices;
  const Index tip = static_cast<Index>(mesh.vertex_count());
  mesh.positions.emplace_back(4.5, 4.5, 0);
  mesh.add_triangle(rim[1], rim[0], tip);
  for (Vec3& p : mesh.positions) p.z() = 0.2 * std::sin(p.x());
  const FillResult result = fill(mesh);
  check_invariants(mesh, result);
  CHECK(report_of(result.mesh).boundary_loops == 1);
}

TEST_CASE("an island that touches the rim in one corner is joined there") {
  PolyMesh mesh = cut(sheet(12, 12), Vec3(6, 6, 0), 4.2).mesh;
  Progress progress;
  const Index corner = analyse_holes(mesh, progress).holes[1].vertices[0];
  const Vec3 at = mesh.positions[corner];
  const Vec3 inwards = (Vec3(6, 6, 0) - at).normalized();
  const Vec3 across(-inwards.y(), inwards.x(), 0);
  const Index first = static_cast<Index>(mesh.vertex_count());
  mesh.positions.push_back(at + 2 * inwards - 0.2 * across);
  mesh.positions.push_back(at + 2 * inwards + 0.2 * across);
  mesh.add_triangle(corner, first, first + 1);
  for (const Fairness fairness : all_fairness) {
    const FillResult result = fill(mesh, by(fairness));
    check_invariants(mesh, result, 1);
    for (const Finding& finding : result.warnings) UNSCOPED_INFO(finding.message);
    CHECK(filled(result) == 2);
    CHECK(report_of(result.mesh).nonmanifold_vertices == 0);
  }
}

TEST_CASE("a gap between two tubes is bridged") {
  const PolyMesh lower = open_tube(1, 3, 32, 10);
  const PolyMesh mesh = merged(lower, translated(lower, Vec3(0, 0, 3.7)));
  const FillResult result = fill(mesh);
  check_invariants(mesh, result);
  const MeshReport after = report_of(result.mesh);
  CHECK(after.components == 1);
  CHECK(after.boundary_loops == 2);
}

TEST_CASE("what is chosen is filled and nothing else") {
  const PolyMesh mesh = cut(cut(sheet(20, 20), Vec3(5, 10, 0), 2.5).mesh, Vec3(14, 10, 0), 4.5).mesh;
  FillOptions options;
  const auto open = [&] {
    std::vector<Index> ids;
    const FillResult result = fill(mesh, options);
    for (Index id = 0; id < result.outcomes.size(); ++id) {
      if (result.outcomes[id].action == FillAction::Leave) ids.push_back(id);
      CHECK(result.outcomes[id].action != FillAction::Failed);
    }
    return ids;
  };
  options.flat_caps = true;
  CHECK(open() == std::vector<Index>{0});
  CHECK(codes_of(fill(mesh, options)) == std::vector<std::string>{"W_OUTER_LEFT"});
  options.max_diameter = 6;
  CHECK(open().size() == 2);
  options.max_diameter = std::numeric_limits<double>::infinity();
  options.selection = Selection::AllButLargest;
  CHECK(open() == std::vector<Index>{0});
  options.only = {2};
  CHECK(open() == std::vector<Index>{0, 1});
  options.only = {2, 7, 9};
  try {
    fill(mesh, options);
    FAIL("unknown holes must be refused");
  } catch (const Error& error) {
    CHECK(error.findings().size() == 2);
    CHECK(error.findings()[0].code == "E_PARAMETER");
  }
}

TEST_CASE("the largest hole is that of the largest diameter, however long its rim") {
  std::vector<Hole> holes(3);
  for (Index id = 0; id < 3; ++id) holes[id].id = id;
  holes[0].diameter = 1;
  holes[0].perimeter = 3;
  holes[1].diameter = 3;
  holes[1].perimeter = 8;
  holes[2].diameter = 2;
  holes[2].perimeter = 20;  // a zigzag
  FillOptions options;
  options.selection = Selection::AllButLargest;
  CHECK(choose_holes(holes, options).is_chosen == std::vector<bool>{true, false, true});
  const std::vector<HoleSize> two_widest{
      {HoleClass::Simple, 1}, {HoleClass::Simple, 3}, {HoleClass::Simple, 3}, {HoleClass::Simple, 2}};
  const std::vector<Naming> named = named_holes(two_widest, Selection::AllButLargest, 100);
  CHECK(named == std::vector{Naming::Named, Naming::Largest, Naming::Named, Naming::Named});
  CHECK(named_holes({}, Selection::AllButLargest, 100).empty());
}

TEST_CASE("an open sheet alone stays as it is, and a closed mesh too") {
  for (const PolyMesh& mesh : {sheet(9, 7), bowl(30, 8), round_sphere(3), cube()}) {
    const FillResult result = fill(mesh);
    CHECK(result.mesh.positions == mesh.positions);
    CHECK(result.mesh.corners == mesh.corners);
    CHECK(result.mesh.channels.empty());
    CHECK(filled(result) == 0);
  }
}

TEST_CASE("ends of a tube that are to be closed get flat caps") {
  FillOptions options;
  options.selection = Selection::All;
  const PolyMesh mesh = open_tube(1, 4, 32, 10);
  const FillResult result = fill(mesh, options);
  check_invariants(mesh, result);
  CHECK(report_of(result.mesh).closed);
  CHECK(result.new_vertices == 0);
  CHECK(result.outcomes[0].method == "minimal");
  CHECK(result.outcomes[0].max_normal_jump == Approx(std::numbers::pi / 2).epsilon(0.02));
  options.flat_caps = false;
  CHECK(fill(mesh, options).new_vertices > 0);
}

TEST_CASE("a hole in a plane is closed in that plane") {
  const PolyMesh mesh = random_cuts(sheet(30, 30), 3, 3, 2, 5).mesh;
  for (const Fairness fairness : all_fairness) {
    const FillResult result = fill(mesh, by(fairness));
    for (const Finding& finding : result.warnings) UNSCOPED_INFO(finding.message);
    CHECK(filled(result) == 3);
    for (const Vec3& position : result.mesh.positions) CHECK(std::abs(position.z()) < 1e-9 * 30 * std::sqrt(2.0));
    CHECK(report_of(result.mesh).area == Approx(900));
  }
}

TEST_CASE("smooth patches come closer to a sphere than flat ones") {
  const PolyMesh mesh = cut(round_sphere(5), Vec3(0, 0, 1), 0.52).mesh;  // 30 degrees
  FillOptions options;
  options.fairness = Fairness::Flat;
  const double flat_jump = fill(mesh, options).outcomes[0].max_normal_jump;
  options.fairness = Fairness::Tangent;
  const FillResult tangent = fill(mesh, options);
  CHECK(tangent.outcomes[0].max_normal_jump < flat_jump / 2);
  CHECK(greatest_radial_error(tangent) < 0.03);
}

TEST_CASE("one hole that can't be filled stays open and keeps no other from it") {
  // A bar through one of two holes of a sheet: every patch of that hole would cut it.
  const PolyMesh holed = cut(cut(sheet(24, 12), Vec3(6, 6, 0), 3).mesh, Vec3(18, 6, 0), 3).mesh;
  PolyMesh bar = translated(scaled(divided_box(2), 2), Vec3(5, 5, -1));
  const PolyMesh mesh = merged(holed, bar);
  const FillResult result = fill(mesh);
  check_invariants(mesh, result);
  std::map<FillAction, int> actions;
  for (const HoleOutcome& outcome : result.outcomes) ++actions[outcome.action];
  CHECK(actions == std::map<FillAction, int>{{FillAction::Fill, 1}, {FillAction::Leave, 1}, {FillAction::Failed, 1}});
  CHECK(codes_of(result) == std::vector<std::string>{"W_OUTER_LEFT", "W_HOLE_FAILED"});
}

TEST_CASE("holes of which the same is to be reported share one finding") {
  const PolyMesh mesh = random_cuts(round_sphere(3), 9, 4, 0.2, 0.3).mesh;
  FillResult result = fill(mesh);
  REQUIRE(result.outcomes.size() == 4);
  for (HoleOutcome& outcome : result.outcomes) {
    outcome.method = "minimal";
    outcome.reason = "one reason";
    outcome.confidence = 1;
    outcome.max_normal_jump = 0;
  }
  result.outcomes[2].reason = "another";
  result.outcomes[3].action = FillAction::Failed;
  const Findings findings = fill_findings(mesh, result);
  REQUIRE(findings.size() == 3);
  CHECK(findings[0].code == "W_HOLE_FAILED");
  CHECK(findings[0].message.starts_with("Hole 3 stays open"));
  CHECK(findings[1].code == "W_FALLBACK");
  CHECK(findings[1].message.starts_with("Holes 0 and 1 were filled flat instead (one reason)"));
  CHECK(findings[1].subjects.size() == 2);
  CHECK(findings[2].message.starts_with("Hole 2 was filled"));
}

TEST_CASE("soups keep their vertices and are closed where their corners lie") {
  const PolyMesh mesh = random_cuts(round_sphere(3), 9, 2, 0.3, 0.5).mesh;
  const PolyMesh soup = as_soup(mesh);
  const FillResult result = fill(soup);
  CHECK(begins_with(result.mesh, soup));
  CHECK(filled(result) == 2);
  CHECK(codes_of(result).front() == "W_WELDED");
  CHECK(fill(result.mesh).outcomes.empty());  // seen welded, it is closed
}

TEST_CASE("attributes are continued into patches, and those given stay") {
  PolyMesh mesh = cut(round_sphere(4), Vec3(0, 0, 1), 0.4).mesh;
  std::vector<float> heights, normals;
  std::vector<std::uint8_t> colours;
  for (const Vec3& p : mesh.positions) {
    heights.push_back(static_cast<float>(p.x()));
    colours.insert(colours.end(), {200, static_cast<std::uint8_t>(100 + 50 * p.y()), 0});
    for (const double c : p) normals.push_back(static_cast<float>(c));
  }
  const std::vector<std::int32_t> groups(mesh.face_count(), 7);
  const std::vector<double> corners(2 * mesh.corners.size(), 0.5);
  mesh.channels = {{"quality", Domain::Vertex, 1, heights, {}},
                   {"color", Domain::Vertex, 3, colours, {}},
                   {"normal", Domain::Vertex, 3, normals, {}},
                   {"group", Domain::Face, 1, groups, {"a"}},
                   {"uv", Domain::Corner, 2, corners, {}}};
  const FillResult result = fill(mesh);
  REQUIRE(filled(result) == 1);
  const PolyMesh& grown = result.mesh;
  for (const Finding& finding : validate(grown)) FAIL(finding.message);
  const auto& grown_heights = std::get<std::vector<float>>(grown.channel("quality", Domain::Vertex)->data);
  const auto& grown_colours = std::get<std::vector<std::uint8_t>>(grown.channel("color", Domain::Vertex)->data);
  const auto& grown_normals = std::get<std::vector<float>>(grown.channel("normal", Domain::Vertex)->data);
  CHECK(std::equal(heights.begin(), heights.end(), grown_heights.begin()));
  CHECK(std::equal(colours.begin(), colours.end(), grown_colours.begin()));
  for (std::size_t v = mesh.vertex_count(); v < grown.vertex_count(); ++v) {
    const Vec3& p = grown.positions[v];
    CHECK(std::abs(grown_heights[v] - p.x()) < 0.06);  // x is nearly harmonic over a flat cap
    CHECK(grown_colours[3 * v] == 200);
    CHECK(std::abs(grown_colours[3 * v + 1] - (100 + 50 * p.y())) < 4);
    CHECK(Vec3(grown_normals[3 * v], grown_normals[3 * v + 1], grown_normals[3 * v + 2]).dot(p.normalized()) > 0.95);
  }
  CHECK(std::get<std::vector<std::int32_t>>(grown.channel("group", Domain::Face)->data).back() == 7);
  CHECK(std::isnan(std::get<std::vector<double>>(grown.channel("uv", Domain::Corner)->data).back()));
  const auto& ids = std::get<std::vector<std::int32_t>>(grown.channel("patch_id", Domain::Face)->data);
  CHECK(std::count(ids.begin(), ids.end(), 0) == static_cast<std::ptrdiff_t>(result.new_faces));
  CHECK(ids.front() == -1);
}

TEST_CASE("patches are made in single precision where the result will be") {
  FillOptions options;
  options.precision = Precision::Single;
  const FillResult result = fill(random_cuts(round_sphere(4), 2, 3, 0.2, 0.4).mesh, options);
  REQUIRE(result.new_vertices > 20);
  for (std::size_t v = result.mesh.vertex_count() - result.new_vertices; v < result.mesh.vertex_count(); ++v) {
    for (const double c : result.mesh.positions[v]) CHECK(c == static_cast<double>(static_cast<float>(c)));
  }
}

TEST_CASE("a fill can be cancelled at any time, and its progress never falls") {
  const PolyMesh mesh = random_cuts(round_sphere(4), 3, 4, 0.1, 0.3).mesh;
  std::atomic<bool> cancel = false;
  double last = 0;
  Progress counting([&](double fraction, const std::string&) {
    CHECK(fraction >= last);
    last = fraction;
  });
  fill_holes(mesh, {}, counting);
  CHECK(last == 1);
  for (const double stop : {0.0, 0.1, 0.5, 0.9}) {
    cancel = false;
    Progress stopped([&](double fraction, const std::string&) { cancel = cancel || fraction >= stop; }, &cancel);
    CHECK_THROWS_AS(fill_holes(mesh, {}, stopped), Cancelled);
  }
}
