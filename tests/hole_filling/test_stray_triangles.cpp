// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/fill_findings.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// A sheet with a round hole; at its left end triangles can be hung.
struct HoledSheet {
  PolyMesh mesh = cut(sheet(30, 30), Vec3(15, 15, 0), 7).mesh;
  Index left = 0, beside = 0;  ///< of the rim: its leftmost vertex and the one from which the faces run to it

  HoledSheet() {
    const Hole hole = round_hole();
    const auto x = [&](Index v) { return mesh.positions[v].x(); };
    const auto found = std::ranges::min_element(hole.vertices, {}, x);
    left = *found;
    beside = found == hole.vertices.begin() ? hole.vertices.back() : *(found - 1);
  }

  Hole round_hole() const {
    Progress progress;
    const HoleAnalysis analysis = analyse_holes(mesh, progress);
    return *std::ranges::find(analysis.holes, HoleClass::Simple, &Hole::kind);
  }

  Index add(const Vec3& place) {
    mesh.positions.push_back(place);
    return static_cast<Index>(mesh.positions.size() - 1);
  }
};

// Above the hole, and below the sheet beyond its rim.
const Vec3 above(12, 10, 1.5), above_too(14, 10.5, 1.5), behind(13, 6, -1);

std::size_t intersections(const PolyMesh& mesh) {
  Progress progress;
  return find_self_intersections(mesh, progress).count;
}

}  // namespace

TEST_CASE("triangles that hang in a hole by a corner and that no patch can join are left to hang, and told") {
  HoledSheet scan;
  const Index a = scan.add(above), b = scan.add(above_too), c = scan.add(behind);
  scan.mesh.add_triangle(scan.left, a, b);
  scan.mesh.add_triangle(a, c, b);
  const std::size_t before = intersections(scan.mesh);
  REQUIRE(before > 0);
  const FillResult result = fill(scan.mesh);
  const auto& holes = result.analysis.holes;
  const auto stray = std::ranges::find(holes, 4, [](const Hole& hole) { return hole.vertices.size(); });
  REQUIRE(stray != holes.end());
  REQUIRE(stray->companions.size() == 1);
  CHECK(result.outcomes[stray->id].action == FillAction::Leave);
  CHECK(result.outcomes[stray->id].reason == hangs_at_rim);
  CHECK(result.outcomes[stray->companions[0]].action == FillAction::Fill);
  CHECK(intersections(result.mesh) == before);
  CHECK(begins_with(result.mesh, scan.mesh));
  CHECK(sentence_of(result, "W_STRAYS") ==
        "Hole " + std::to_string(stray->companions[0]) +
            " was closed past 2 triangles that hang there by a corner and stay as they "
            "were: delete them in the source.");
}

TEST_CASE("a triangle that hangs in a hole by a corner becomes part of the patch where it can") {
  HoledSheet scan;
  const Index a = scan.add(Vec3(10, 14.2, 0.2)), b = scan.add(Vec3(10, 15.4, 0.2));
  scan.mesh.add_triangle(scan.left, a, b);
  const FillResult result = fill(scan.mesh);
  CHECK(filled(result) == 2);
  CHECK(sentence_of(result, "W_STRAYS").empty());
  CHECK(intersections(result.mesh) == 0);
  CHECK(begins_with(result.mesh, scan.mesh));
}

TEST_CASE("a rim that goes through the surface is told as the reason why its hole stays open") {
  const auto with_flap = [](const Vec3& end) {
    HoledSheet scan;
    const Index a = scan.add(above), b = scan.add(end);
    scan.mesh.add_triangle(scan.left, scan.beside, a);
    scan.mesh.add_triangle(a, scan.beside, b);
    return fill(scan.mesh);
  };
  CHECK(sentence_of(with_flap(behind), "W_HOLE_FAILED").find("its rim goes through the surface") != std::string::npos);
  CHECK(sentence_of(with_flap(Vec3(20, 12, 2)), "W_HOLE_FAILED").find("goes through") == std::string::npos);
}
