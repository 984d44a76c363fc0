// SPDX-License-Identifier: GPL-3.0-or-later
// Patches stay near their holes; what they are for the whole model is reported.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// Walls of unit radius below, 3 high, that lean inwards towards an open end; closed below. The open end is a cut of
/// this radius.
PolyMesh leaning_walls(double top) {
  std::vector<Vec2> profile = {{0, -3}};
  constexpr int rings = 24;
  for (int i = 0; i <= rings; ++i) {
    const double share = static_cast<double>(i) / rings;
    profile.emplace_back(1 + share * (top - 1), 3 * (share - 1));
  }
  return revolved(profile, 48);
}

/// The unit ball up to a height, cut off flat.
PolyMesh ball_below(double height) {
  std::vector<Vec2> profile = {{0, -1}};
  constexpr int rings = 30;
  for (int i = 1; i <= rings; ++i) {
    const double angle = std::acos(-height) * i / rings;
    profile.emplace_back(std::sin(angle), -std::cos(angle));
  }
  return revolved(profile, 60);
}

FillResult filled_by_number(const PolyMesh& mesh, Fairness fairness = Fairness::Implicit) {
  FillOptions options;
  options.only = {0};
  options.fairness = fairness;
  options.flat_caps = fairness == Fairness::Implicit;
  FillResult result = fill(mesh, options);
  check_invariants(mesh, result);
  return result;
}

/// Of walls' open end, which lies in z = 0.
double height_of(const PolyMesh& mesh, const FillResult& result) {
  double height = 0;
  for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v)
    height = std::max(height, std::abs(result.mesh.positions[v].z()));
  return height;
}

bool warns_of_growth(const FillResult& result) {
  return std::ranges::any_of(result.warnings, [](const Finding& finding) { return finding.code == "W_BOX_GROWN"; });
}

}  // namespace

TEST_CASE("no patch rises farther than half its hole's diameter and 1.3 times what faired triangles do") {
  for (const double top : {0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.3}) {
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}}) {
      PolyMesh mesh = leaning_walls(top);
      if (seed > 0) mesh = with_noisy_rims(mesh, seed, 0.3);
      const FillResult result = filled_by_number(mesh);
      REQUIRE(result.outcomes[0].action == FillAction::Fill);
      const double faired = height_of(mesh, filled_by_number(mesh, Fairness::Tangent));
      CAPTURE(top, seed, result.outcomes[0].method, height_of(mesh, result), faired);
      CHECK(height_of(mesh, result) <= std::max(result.analysis.holes[0].diameter / 2, 1.3 * faired) * 1.001);
    }
  }
}

TEST_CASE("a high patch isn't refused where the faired triangles that it is compared with fold back at the rim") {
  // Seen on this scan: half a bone is gone, and faired triangles lay on the half that is left.
  const KnownScan scan = known_scan(ScanKind::Bones, 50202);
  FillOptions options;
  options.selection = Selection::All;
  const FillResult result = fill(scan.mesh, options);
  const auto longest = std::ranges::max_element(
      result.analysis.holes, {}, [](const Hole& hole) { return hole.kind == HoleClass::Outer ? 0 : hole.diameter; });
  const auto& outcome = result.outcomes[static_cast<std::size_t>(longest - result.analysis.holes.begin())];
  CAPTURE(outcome.method);
  CHECK(outcome.action == FillAction::Fill);
  CHECK(outcome.max_normal_jump < 0.5);
}

TEST_CASE("an open end that is named by its number goes on as its walls do; chosen with all others it gets a lid") {
  const PolyMesh cut_ball = ball_below(0.5);
  const FillResult named = filled_by_number(cut_ball);
  REQUIRE(named.analysis.holes[0].kind == HoleClass::Outer);
  FillOptions all;
  all.selection = Selection::All;
  const FillResult lid = fill(cut_ball, all);
  CHECK(lid.new_vertices == 0);
  // A click on it in the window is a request of its own.
  FillOptions clicked;
  clicked.selection = Selection::None;
  clicked.flat_caps = true;
  HoleRequest request;
  request.holes = {0};
  request.fill = true;
  clicked.requests = {request};
  CHECK(fill(cut_ball, clicked).mesh.positions == named.mesh.positions);
  CHECK(named.new_vertices > 100);
  // The rest of the sphere is what was cut off: the lid is a third of a radius off in the mean.
  double off = 0;
  for (std::size_t v = cut_ball.vertex_count(); v < named.mesh.vertex_count(); ++v)
    off += std::abs(named.mesh.positions[v].norm() - 1) / static_cast<double>(named.new_vertices);
  CHECK(off < 0.05);
}

TEST_CASE("a wide end of a thing is its base, also where it is ragged or bent") {
  const auto class_of = [](const PolyMesh& mesh) {
    Progress progress;
    return analyse_holes(mesh, progress).holes[0].kind;
  };
  for (const double waves : {2.0, 3.0, 5.0}) {
    PolyMesh ragged = leaning_walls(0.95);
    for (Vec3& p : ragged.positions) {
      if (p.z() > -1e-9) p.z() += 0.1 * std::cos(waves * std::atan2(p.y(), p.x()));
    }
    CAPTURE(waves);
    CHECK(class_of(ragged) == HoleClass::Outer);
  }
  // A hole of the same width in a round body isn't: the surface bends over it.
  CHECK(class_of(cut(round_sphere(4), Vec3(0, 0, 1), 0.8).mesh) != HoleClass::Outer);
}

TEST_CASE("a box that grows by over a twentieth is reported with the hole and the side, a smaller growth isn't") {
  FillOptions options;
  options.selection = Selection::All;
  options.flat_caps = false;
  const FillResult grown = fill(bowl(60, 16), options);
  REQUIRE(warns_of_growth(grown));
  const auto finding = std::ranges::find(grown.warnings, "W_BOX_GROWN", &Finding::code);
  CHECK(finding->message.find("along z from 1 to ") != std::string::npos);
  CHECK(finding->subjects.size() == 1);
  options.flat_caps = true;
  CHECK_FALSE(warns_of_growth(fill(bowl(60, 16), options)));
  // A cap of 0.09 is missing of a ball of 2: it grows by a little less than a twentieth.
  const double reach = std::sqrt(2 * 0.09);
  CHECK_FALSE(warns_of_growth(fill(cut(round_sphere(4), Vec3(0, 0, 1), reach).mesh)));
  CHECK_FALSE(warns_of_growth(fill(cut(sheet(20, 20), Vec3(10, 9, 0), 4).mesh)));
}
