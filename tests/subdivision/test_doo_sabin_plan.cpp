// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cstring>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

/// What a plan costs, refuses and promises, beside its surfaces.
namespace croquis::test {
namespace {

using subdivision::Depth;
using subdivision::DooSabinPlan;
using subdivision::make_cage;
using subdivision::PositionBuffers;

/// A torus with one edge of a hundred tagged.
PolyMesh sparsely_tagged_torus(Index side) {
  PolyMesh mesh = torus(side, side);
  Random random(3);
  for (const VertexPair& edge : all_edges(mesh)) {
    if (random.below(100) == 0) mesh.tags.creases.push_back({edge, infinite_sharpness});
  }
  return mesh;
}

TEST_CASE("positions have the same bits with any number of threads") {
  const Subdivided result = subdivide(sparsely_tagged_torus(80), 2);
  for (const int threads : {2, 3, 8}) {
    PositionBuffers buffers;
    result.plan.positions(result.cage.positions, buffers, threads);
    for (std::size_t k = 0; k < buffers.levels.size(); ++k) {
      REQUIRE(buffers.levels[k].size() == result.buffers.levels[k].size());
      CHECK(std::memcmp(buffers.levels[k].data(), result.buffers.levels[k].data(),
                        buffers.levels[k].size() * sizeof(Vec3)) == 0);
    }
  }
}

TEST_CASE("positions are computed again into the same memory") {
  Subdivided result = subdivide(bolt_loop(), 3);
  std::vector<const Vec3*> places;
  for (const auto& level : result.buffers.levels) {
    places.push_back(level.data());
    CHECK(level.capacity() == level.size());
  }
  std::vector<Vec3> moved = result.cage.positions;
  moved[3] += Vec3(0.1, 0.2, 0.3);
  result.plan.positions(moved, result.buffers);
  for (std::size_t k = 0; k < places.size(); ++k) CHECK(result.buffers.levels[k].data() == places[k]);

  PositionBuffers fresh;
  result.plan.positions(moved, fresh);
  CHECK(fresh.levels.back() == result.buffers.levels.back());
}

TEST_CASE("the last level takes at most a hundred bytes per face") {
  for (const PolyMesh& mesh : {torus(50, 50), sparsely_tagged_torus(50), grid(50, 50), icosahedron()}) {
    const Subdivided result = subdivide(mesh, 3);
    const auto faces = static_cast<double>(result.topology(3).face_count());
    const auto bytes = static_cast<double>(result.plan.bytes(3) + result.points(3).size() * sizeof(Vec3));
    CHECK(bytes / faces <= 100);
    CHECK(bytes / faces >= 84);
  }
}

TEST_CASE("too many faces are refused with their count before anything is made") {
  const auto cage = make_cage(bolt()).cage;
  Progress progress;
  try {
    DooSabinPlan(cage, {}, Depth(5, 14000), progress);
    FAIL("made");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 1);
    const Finding& finding = error.findings().front();
    CHECK(finding.code == "E_TOO_MANY_FACES");
    CHECK(finding.category == Category::Limit);
    CHECK(finding.message.find("14338 faces, 28672 edges and 14336 vertices") != std::string::npos);
    CHECK(finding.message.find("14000") != std::string::npos);
  }
  CHECK_NOTHROW(DooSabinPlan(cage, {}, Depth(5, 14338), progress));
  // Levels that no memory could hold, and more than 32 bits of corners, are refused at once.
  CHECK_THROWS_AS(DooSabinPlan(cage, {}, 40, progress), Error);
  CHECK_THROWS_AS(DooSabinPlan(cage, {}, Depth(16, ~std::size_t{0}), progress), Error);
}

TEST_CASE("a plan can be stopped, and reports how far it is") {
  const auto cage = make_cage(torus(20, 20)).cage;
  std::atomic<bool> cancel{false};
  std::vector<double> fractions;
  Progress progress(
      [&](double fraction, const std::string&) {
        fractions.push_back(fraction);
        if (fractions.size() == 2) cancel = true;
      },
      &cancel);
  CHECK_THROWS_AS(DooSabinPlan(cage, {}, 4, progress), Cancelled);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));

  fractions.clear();
  Progress whole([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  const DooSabinPlan plan(cage, {}, 3, whole);
  CHECK(fractions.back() == 1);
}

TEST_CASE("positions of another cage are refused") {
  Subdivided result = subdivide(bolt(), 1);
  CHECK_THROWS_AS(result.plan.positions(cube().positions, result.buffers), Error);
}

TEST_CASE("no levels are the cage, and a cage without faces has empty levels") {
  const Subdivided none = subdivide(bolt(), 0);
  CHECK(none.plan.levels() == 0);
  CHECK(none.points(0) == bolt().positions);
  const Subdivided empty = subdivide(PolyMesh{}, 3);
  CHECK(counts(empty.topology(3)) == Counts{0, 0, 0});
}

TEST_CASE("faces of thousands of corners take linear memory") {
  const Subdivided result = subdivide(single_face(5000), 2);
  CHECK(fault(result.topology(2)) == "");
  CHECK(result.plan.bytes(1) < 5000 * 500);
  const Subdivided cap = subdivide(pyramid(3000), 1);
  CHECK(fault(cap.topology(1)) == "");
}

}  // namespace
}  // namespace croquis::test
