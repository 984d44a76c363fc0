// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "croquis/hole_filling/hole_analysis.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

std::map<HoleClass, std::size_t> classes_of(const PolyMesh& mesh) {
  Progress progress;
  std::map<HoleClass, std::size_t> counts;
  for (const Hole& hole : analyse_holes(mesh, progress).holes) ++counts[hole.kind];
  return counts;
}

using Counts = std::map<HoleClass, std::size_t>;

/// The same shape in another place, size and position, which must not matter.
PolyMesh moved(const PolyMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const double angle = random.between(0, 6);
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  const Vec3 axis = Vec3(x, y, 0.3).normalized();
  return translated(scaled(rotated(mesh, angle, axis), random.between(0.01, 100)), Vec3(5, -3, 2));
}

}  // namespace

TEST_CASE("open sections and borders are OUTER: tube, bowl, sheet, bust") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    CHECK(classes_of(moved(open_tube(1, 4, 32, 12), seed)) == Counts{{HoleClass::Outer, 2}});
    CHECK(classes_of(moved(bowl(40, 12), seed)) == Counts{{HoleClass::Outer, 1}});
    CHECK(classes_of(moved(sheet(12, 9), seed)) == Counts{{HoleClass::Outer, 1}});
    CHECK(classes_of(moved(bust(40, 50), seed)) == Counts{{HoleClass::Outer, 1}});
  }
}

TEST_CASE("holes inside open surfaces are not OUTER") {
  CHECK(classes_of(cut(sheet(20, 20), Vec3(10, 9, 0), 4).mesh) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Simple, 1}});
  CHECK(classes_of(cut(bust(80, 100), Vec3(0.4, 0, 1.5), 0.25).mesh) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Simple, 1}});
}

TEST_CASE("a sphere's hole is no border up to 30 % of the diagonal and more, a half sphere's is") {
  const PolyMesh sphere = round_sphere(5);
  const double diagonal = 2 * std::sqrt(3.0);
  for (const double share : {0.1, 0.2, 0.3, 0.4}) {
    const double half = share * diagonal / 2;                            // the rim's radius
    const double reach = std::sqrt(2 - 2 * std::sqrt(1 - half * half));  // chord from the pole to the rim
    CHECK(classes_of(cut(sphere, Vec3(0.6, 0, 0.8), reach).mesh) == Counts{{HoleClass::Simple, 1}});
  }
  CHECK(classes_of(cut(sphere, Vec3(0, 0, 1), std::sqrt(2.0)).mesh) == Counts{{HoleClass::Outer, 1}});
}

TEST_CASE("a wide opening cut off flat is OUTER where the surface leads out of it, a torn one of that size isn't") {
  const PolyMesh ball = uv_sphere(60, 40);
  const auto without_cap = [&](double height) {
    std::vector<Index> cap;
    for (Index f = 0; f < ball.face_count(); ++f) {
      const auto t = ball.face(f);
      if (std::ranges::any_of(t, [&](Index v) { return ball.positions[v].z() < height; })) cap.push_back(f);
    }
    return without_faces(ball, cap);
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    CHECK(classes_of(moved(without_cap(-0.7), seed)) == Counts{{HoleClass::Outer, 1}});    // 0.43 of the diagonal
    CHECK(classes_of(moved(without_cap(-0.95), seed)) == Counts{{HoleClass::Simple, 1}});  // 0.2
  }
}

TEST_CASE("rims of at most ten edges are small") {
  const PolyMesh squares = grid(10, 10);
  CHECK(classes_of(without_faces(squares, std::vector<Index>{44})) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Small, 1}});
  CHECK(classes_of(without_faces(squares, std::vector<Index>{42, 43, 44, 45})) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Small, 1}});
  CHECK(classes_of(without_faces(squares, std::vector<Index>{43, 44, 45, 53, 54, 55})) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Small, 1}});
  CHECK(classes_of(without_faces(squares, std::vector<Index>{43, 44, 45, 53, 54, 55, 63, 64, 65})) ==
        Counts{{HoleClass::Outer, 1}, {HoleClass::Simple, 1}});
}

TEST_CASE("a missing row of squares is a slit") {
  const PolyMesh squares = grid(20, 10);
  std::vector<Index> row;
  for (Index i = 4; i < 15; ++i) row.push_back(5 * 20 + i);
  CHECK(classes_of(without_faces(squares, row)) == Counts{{HoleClass::Outer, 1}, {HoleClass::Slit, 1}});
  std::vector<Index> rows = row;
  for (const Index f : row) rows.push_back(f + 20), rows.push_back(f + 40);
  CHECK(classes_of(without_faces(squares, rows)) == Counts{{HoleClass::Outer, 1}, {HoleClass::Simple, 1}});
}

TEST_CASE("a piece of surface in a hole is its island") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const PolyMesh mesh = moved(cut_ring(round_sphere(5), Vec3(0, 0.6, 0.8), 0.25, 0.6).mesh, seed);
    CHECK(classes_of(mesh) == Counts{{HoleClass::Islands, 2}});
  }
  Progress progress;
  const auto analysis = analyse_holes(cut_ring(sheet(30, 30), Vec3(15, 15, 0), 4, 9).mesh, progress);
  REQUIRE(analysis.holes.size() == 3);
  CHECK(analysis.holes[0].kind == HoleClass::Outer);
  CHECK(analysis.holes[1].companions == std::vector<Index>{2});
  CHECK(analysis.holes[2].companions == std::vector<Index>{1});
}

TEST_CASE("a sheet beside a hole or far above it is no island") {
  const PolyMesh holed = cut(sheet(30, 30), Vec3(15, 15, 0), 7).mesh;
  const PolyMesh patch = translated(sheet(5, 5), Vec3(12.5, 12.5, 0));
  CHECK(classes_of(merged(holed, patch)) == Counts{{HoleClass::Outer, 1}, {HoleClass::Islands, 2}});
  CHECK(classes_of(merged(holed, translated(patch, Vec3(0, 0, 12)))) ==
        Counts{{HoleClass::Outer, 2}, {HoleClass::Simple, 1}});
  CHECK(classes_of(merged(holed, translated(patch, Vec3(10, 0, 0.5)))) ==
        Counts{{HoleClass::Outer, 2}, {HoleClass::Simple, 1}});
  CHECK(classes_of(merged(holed, flipped(patch))) == Counts{{HoleClass::Outer, 2}, {HoleClass::Simple, 1}});
}

TEST_CASE("rims of two pieces that face each other are a tunnel") {
  const PolyMesh lower = open_tube(1, 4, 32, 12);
  const PolyMesh upper = translated(lower, Vec3(0, 0, 4.8));
  CHECK(classes_of(merged(lower, upper)) == Counts{{HoleClass::Tunnel, 2}, {HoleClass::Outer, 2}});
  const PolyMesh apart = translated(lower, Vec3(0, 0, 7));
  CHECK(classes_of(merged(lower, apart)) == Counts{{HoleClass::Outer, 4}});
  const PolyMesh beside = translated(lower, Vec3(2.1, 0, 0));
  CHECK(classes_of(merged(lower, beside)) == Counts{{HoleClass::Outer, 4}});
}
