// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "algorithms/remeshing/improvement.h"
#include "algorithms/remeshing/openings.h"
#include "algorithms/remeshing/surface_parts.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/self_intersection.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

TEST_CASE("vertices that were moved through the surface go back, and no others") {
  const PolyMesh mesh = round_sphere(3);
  PolyMesh moved = mesh;
  for (Vec3& p : moved.positions) p *= 1.01;
  moved.positions[0] *= -1;
  moved.positions[100] *= -0.5;
  Progress progress;
  CHECK(undo_where_cut(moved, mesh.positions, 1, progress) == 0);
  Progress again;
  CHECK(find_self_intersections(moved, again).count == 0);
  std::size_t back = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) back += moved.positions[v] == mesh.positions[v] ? 1U : 0U;
  CHECK(back >= 2);
  CHECK(back < mesh.vertex_count() / 2);
}

TEST_CASE("however vertices were moved, they go back until nothing intersects") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const PolyMesh mesh = round_sphere(3);
    PolyMesh moved = mesh;
    Random random(seed);
    for (Vec3& p : moved.positions)
      if (random.unit() < 0.2 * static_cast<double>(seed)) p *= random.between(-1, 1.5);
    Progress progress, again;
    CHECK(undo_where_cut(moved, mesh.positions, 2, progress) == 0);
    CHECK(find_self_intersections(moved, again).count == 0);
  }
}

TEST_CASE("slab by slab the same cuts are found as at once") {
  for (const int level : {3, 5, 6}) {
    const PolyMesh mesh =
        merged(round_sphere(level), translated(scaled(round_sphere(level - 1), 0.9), Vec3(0.3, 0.2, 0.1)));
    CAPTURE(mesh.face_count());
    Progress progress;
    const auto expected = find_self_intersections(mesh, progress, {.max_pairs = 1000000});
    CHECK(expected.count > 10);
    for (const int threads : {1, 3}) {
      Progress again;
      CHECK(find_cuts(mesh, threads, again) == expected.pairs);
    }
  }
}

TEST_CASE("trimmed borders are manifold, whatever is beyond") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const PolyMesh mesh = sheet(15, 15);
    std::vector<std::uint8_t> beyond;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) beyond.push_back(random.unit() < 0.15 ? 1 : 0);
    Progress progress;
    const MeshReport report = inspect(trimmed(mesh, beyond), false, progress);
    CHECK(report.nonmanifold_vertices == 0);
    CHECK(report.nonmanifold_edges == 0);
  }
}

TEST_CASE("sheets that no point lies on are dropped, those with points stay") {
  PolyMesh mesh = merged(round_sphere(3), translated(scaled(round_sphere(3), 0.5), Vec3(3, 0, 0)));
  const PolyMesh data = round_sphere(3);
  Progress progress;
  CHECK(drop_detached(mesh, data.positions, 1, progress) == 1);
  CHECK(mesh.face_count() == data.face_count());
  Progress again;
  CHECK(drop_detached(mesh, data.positions, 1, again) == 0);
}

TEST_CASE("openings are distinguished from rims that stay open, and closed by patches") {
  // Given: a bowl with a hole, which is to be closed. Made: the same, so that both its rims are loops.
  const PolyMesh mesh = cut(bowl(48, 20), Vec3(0, 0, -1), 0.3).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  REQUIRE(analysis.holes.size() == 2);
  const HoleChoice choice = choose_holes(analysis.holes, {});
  const RemeshPieces pieces = make_pieces(mesh, analysis, choice, {}, {});
  REQUIRE(pieces.pieces.size() == 1);
  CHECK(pieces.pieces[0].ends);
  PolyMesh surface = mesh;
  Progress looking;
  Openings openings = find_openings(surface, mesh, pieces.pieces[0], pieces, {}, looking);
  CHECK(openings.meant == 1);
  REQUIRE(openings.loops.size() == 1);
  CHECK(analysis.holes[openings.loops[0].hole].kind != HoleClass::Outer);
  Progress patching;
  CHECK(close_by_patches(surface, openings, {}, patching).closed.size() == 1);
  CHECK(openings.loops.empty());
  Progress last;
  CHECK(inspect(surface, true, last).boundary_loops == 1);
}
