// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// The sentence of the only warning with that code.
std::string sentence(const PolyMesh& mesh, const std::string& code) { return sentence_of(fill(mesh, {}), code); }

/// The mesh, its first faces with corners of their own where they have the vertex.
PolyMesh with_doubled_vertices(PolyMesh mesh, Index count) {
  for (Index vertex = 0; vertex < count; ++vertex) {
    const auto corner = std::find(mesh.corners.begin(), mesh.corners.end(), vertex);
    *corner = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[vertex]);
  }
  return mesh;
}

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

TEST_CASE("warnings about holes speak of one thing and of many as people do") {
  const PolyMesh ball = round_sphere(3);
  CHECK(sentence(tetrahedra_sharing_edge(), "W_NONMANIFOLD") ==
        "1 non-manifold edge has more than two faces and stays as it is: separate the sheets that meet in it.");
  CHECK(sentence(merged(tetrahedra_sharing_edge(), translated(tetrahedra_sharing_edge(), Vec3(9, 0, 0))),
                 "W_NONMANIFOLD") ==
        "2 non-manifold edges have more than two faces and stay as they are: separate the sheets that meet in them.");
  CHECK(sentence(with_doubled_vertices(ball, 1), "W_WELDED") ==
        "1 vertex lies exactly on another one and counts as the same; it is written as it was, so weld the source to "
        "get a closed file.");
  CHECK(sentence(with_doubled_vertices(ball, 2), "W_WELDED") ==
        "2 vertices lie exactly on another one and count as the same; they are written as they were, so weld the "
        "source to get a closed file.");
  PolyMesh shaken = with_doubled_vertices(ball, 2);
  for (const Index copy : {0U, 1U}) shaken.positions[ball.vertex_count() + copy] *= 1 + 1e-9;
  CHECK(sentence(shaken, "W_WELDED") ==
        "2 vertices of rims lie nearly on another one (within 3e-10 of the diagonal) and count as the same; they are "
        "written as before: weld the source, or keep them apart with --weld 0.");
  CHECK(sentence(flipped_face(ball, 3), "W_ORIENTATION") ==
        "1 face runs against the neighbours: taken the other way round, and written as it was; flip it in the source.");
  CHECK(sentence(flipped_face(flipped_face(ball, 3), 90), "W_ORIENTATION") ==
        "2 faces run against the neighbours: taken the other way round, and written as they were; flip them in the "
        "source.");
  CHECK(sentence(sheet(6, 6), "W_OUTER_LEFT") ==
        "1 rim looks like the border of an open surface and stayed open: choose all holes, or this one by its number, "
        "to close it too.");
  CHECK(sentence(merged(sheet(6, 6), translated(sheet(6, 6), Vec3(99, 0, 0))), "W_OUTER_LEFT") ==
        "2 rims look like the border of an open surface and stayed open: choose all holes, or these by their numbers, "
        "to close them too.");
}

TEST_CASE("a patch that folds back at its rim is doubtful, a flat one is what was asked for") {
  const PolyMesh sphere = random_cuts(round_sphere(3), 1, 1, 0.3, 0.3).mesh;
  FillResult result = fill(sphere, {});
  REQUIRE(result.outcomes.size() == 1);
  for (const double degrees : {10.0, 119.0, 121.0, 179.0}) {
    for (const char* method : {"implicit", "cgal-c1", "band", "minimal"}) {
      CAPTURE(degrees, method);
      result.outcomes[0].max_normal_jump = degrees * std::numbers::pi / 180;
      result.outcomes[0].method = method;
      const Findings findings = fill_findings(sphere, result);
      const auto folds = std::ranges::count_if(
          findings, [](const Finding& finding) { return finding.message.find("fold") != std::string::npos; });
      CHECK(folds == (degrees > 120 && method != std::string("minimal") ? 1 : 0));
    }
  }
}

TEST_CASE("triangles that hang in a hole by a corner and that no patch can join are left to hang, and reported") {
  HoledSheet scan;
  const Index a = scan.add(above), b = scan.add(above_too), c = scan.add(behind);
  scan.mesh.add_triangle(scan.left, a, b);
  scan.mesh.add_triangle(a, c, b);
  const std::size_t before = intersections(scan.mesh);
  REQUIRE(before > 0);
  const FillResult result = fill(scan.mesh);
  const auto& holes = result.analysis.holes;
  const auto detached = std::ranges::find(holes, 4, [](const Hole& hole) { return hole.vertices.size(); });
  REQUIRE(detached != holes.end());
  REQUIRE(detached->companions.size() == 1);
  CHECK(result.outcomes[detached->id].action == FillAction::Leave);
  CHECK(result.outcomes[detached->id].reason == hangs_at_rim);
  CHECK(result.outcomes[detached->companions[0]].action == FillAction::Fill);
  CHECK(intersections(result.mesh) == before);
  CHECK(begins_with(result.mesh, scan.mesh));
  CHECK(sentence_of(result, "W_STRAYS") ==
        "Hole " + std::to_string(detached->companions[0]) +
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

TEST_CASE("a rim that goes through the surface is given as the reason why its hole stays open") {
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
