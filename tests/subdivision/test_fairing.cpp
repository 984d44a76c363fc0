// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/subdivision/continuity.h"
#include "croquis/subdivision/edge_chain.h"
#include "croquis/subdivision/fairing.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

PolyMesh noisy(PolyMesh mesh, double size, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.positions) {
    p += size * Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  }
  return mesh;
}

FairCage faired(const PolyMesh& mesh, double factor, const FairingOptions& options = {}) {
  Progress progress;
  Fairing fairing(mesh, options, progress);
  return fairing.solve(factor * fairing.default_weight(), progress);
}

/// A ring of sharp edges around a torus of 16 by 8 quads, at one of its sides.
PolyMesh torus_with_ring() {
  std::vector<VertexPair> ring;
  for (Index i = 0; i < 16; ++i)
    ring.push_back({std::min(8 * i, 8 * ((i + 1) % 16)), std::max(8 * i, 8 * ((i + 1) % 16))});
  return tagged(torus(16, 8), ring);
}

ChainShape first_chain(const PolyMesh& mesh, int k) {
  const Refined result = refined(mesh, k);
  const Level& level = result.plan.level(k);
  return chain_shapes(level, edge_chains(level), result.at(k))[0];
}

}  // namespace

TEST_CASE("The energy falls monotonically as the weight falls") {
  for (const PolyMesh& cage :
       {noisy(torus(12, 8), 0.05, 1), noisy(bolt_loop(), 0.1, 2), house(), noisy(grid(6, 5), 0.2, 3)}) {
    Progress progress;
    Fairing fairing(cage, {}, progress);
    double last = -1;
    for (double factor = 1e-4; factor < 1e5; factor *= 4) {
      const FairCage result = fairing.solve(factor * fairing.default_weight(), progress);
      CHECK(result.energy >= last * (1 - 1e-9));
      CHECK(result.energy <= result.energy_before * (1 + 1e-9));
      last = result.energy;
    }
    CHECK(last > 0);
  }
}

TEST_CASE("The default weight takes out noise and keeps the shape") {
  const PolyMesh clean = torus(16, 10);
  const PolyMesh cage = noisy(clean, 0.03, 7);
  const FairCage result = faired(cage, 1);
  CHECK(result.energy < 0.9 * result.energy_before);
  const auto roughness = [](const PolyMesh& mesh) {
    const Refined level = refined(mesh, 2);
    return continuity(level.plan.level(2), level.at(2)).greatest_bend;
  };
  CHECK(roughness(result.mesh) < 0.85 * roughness(cage));
  const auto distance = [&](const PolyMesh& mesh) {
    double sum = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) sum += (mesh.positions[v] - clean.positions[v]).norm();
    return sum;
  };
  CHECK(distance(result.mesh) < distance(cage));
}

TEST_CASE("Large weights move nothing, small ones never beyond reason") {
  const PolyMesh cage = noisy(torus(12, 8), 0.05, 5);
  CHECK(faired(cage, 1e12).greatest_move < 1e-9);
  CHECK(std::isfinite(faired(cage, 1e-6).greatest_move));
}

TEST_CASE("Pins, tags and the boundary stay exactly where they are") {
  PolyMesh cage = noisy(torus_with_ring(), 0.05, 11);
  cage.tags.pins = {3, 44, 77};
  for (const bool keep_planes : {true, false}) {
    FairingOptions options;
    options.keep_planes = keep_planes;
    const FairCage result = faired(cage, 0.01, options);
    CHECK(result.greatest_move > 0.01);
    for (const Index pin : cage.tags.pins) CHECK(result.mesh.positions[pin] == cage.positions[pin]);
    for (const Crease& crease : cage.tags.creases) {
      for (const Index v : crease.vertices) CHECK(result.mesh.positions[v] == cage.positions[v]);
    }
  }
  const PolyMesh open = noisy(grid(4, 4), 0.2, 13);
  const FairCage result = faired(open, 0.01);
  for (Index v = 0; v < open.vertex_count(); ++v) {
    const Index column = v % 5, row = v / 5;
    const bool border = column == 0 || column == 4 || row == 0 || row == 4;
    CHECK((result.mesh.positions[v] == open.positions[v]) == border);
  }
  CHECK(result.mesh.tags == open.tags);
}

TEST_CASE("Chains are made fair on their own, planar ones in their plane, pins held") {
  PolyMesh cage = torus_with_ring();
  Random random(17);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.6, Vec3(1, 2, 2).normalized()));
  for (Index i = 0; i < 16; ++i) {
    cage.positions[8 * i] += Vec3(random.between(-0.1, 0.1), random.between(-0.1, 0.1), 0);
  }
  for (Vec3& p : cage.positions) p = turn * p;
  cage.tags.pins = {0};
  FairingOptions options;
  options.fair_chains = true;
  options.keep_planes = false;
  const auto bends = [](const PolyMesh& mesh) {
    double sum = 0;
    for (Index i = 1; i < 16; ++i) {
      sum +=
          (mesh.positions[8 * (i - 1)] - 2 * mesh.positions[8 * i] + mesh.positions[8 * ((i + 1) % 16)]).squaredNorm();
    }
    return sum;
  };
  const FairCage result = faired(cage, 0.03, options);
  CHECK(bends(result.mesh) < 0.5 * bends(cage));
  CHECK(result.mesh.positions[0] == cage.positions[0]);
  const Vec3 normal = turn * Vec3::UnitZ();
  for (Index i = 0; i < 16; ++i) {
    CHECK(std::abs((result.mesh.positions[8 * i] - cage.positions[8 * i]).dot(normal)) < 1e-14);
  }
  CHECK(first_chain(result.mesh, 2).deviation < 1e-12);
}

TEST_CASE("Where planes are kept the bolt's tags keep their right angle") {
  FairingOptions options;
  for (const bool fair_chains : {false, true}) {
    options.fair_chains = fair_chains;
    const FairCage result = faired(bolt_loop(), 0.02, options);
    CHECK(result.greatest_move > 0.05);
    CHECK(result.energy < result.energy_before);
    for (int k = 0; k <= 3; ++k) {
      const ChainShape shape = first_chain(result.mesh, k);
      CHECK(degrees(shape.least_bend) == Approx(90).margin(1e-9));
      CHECK(degrees(shape.greatest_bend) == Approx(90).margin(1e-9));
    }
  }
  options.keep_planes = false;
  options.fair_chains = false;
  CHECK(degrees(first_chain(faired(bolt_loop(), 0.02, options).mesh, 2).greatest_bend) != Approx(90).margin(0.1));
}

TEST_CASE("Fairing turns with the cage and scales with it") {
  const PolyMesh cage = noisy(torus(10, 8), 0.05, 19);
  const FairCage result = faired(cage, 1);
  const FairCage turned = faired(rotated(scaled(cage, 3), 0.8, Vec3(1, -1, 2).normalized()), 1);
  const PolyMesh expected = rotated(scaled(result.mesh, 3), 0.8, Vec3(1, -1, 2).normalized());
  double gap = 0;
  for (std::size_t v = 0; v < cage.vertex_count(); ++v) {
    gap = std::max(gap, (turned.mesh.positions[v] - expected.positions[v]).norm());
  }
  CHECK(gap < 1e-9);
  CHECK(turned.energy == Approx(result.energy).epsilon(1e-8));
}

TEST_CASE("The same weight gives the same bytes, whatever was asked in between") {
  const PolyMesh cage = noisy(bolt_loop(), 0.1, 23);
  Progress progress;
  Fairing fairing(cage, {}, progress);
  const FairCage first = fairing.solve(0.5, progress);
  fairing.solve(7, progress);
  CHECK(fairing.solve(0.5, progress).mesh.positions == first.mesh.positions);
  Fairing again(cage, {}, progress);
  CHECK(again.solve(0.5, progress).mesh.positions == first.mesh.positions);
  CHECK(fairing.free_point_count() == 12);
}

TEST_CASE("Cages without anything to move come back as they are") {
  const FairCage cube = faired(cube_all_sharp(), 1);
  CHECK(cube.mesh.positions == centred_cube().positions);
  CHECK(cube.greatest_move == 0);
  CHECK(faired(PolyMesh{}, 1).mesh.positions.empty());
  PolyMesh loose = bolt();
  loose.positions.emplace_back(9, 9, 9);
  CHECK(faired(loose, 1).mesh.positions.back() == Vec3(9, 9, 9));
}

TEST_CASE("Weights that are no positive numbers are refused, and a raised flag stops") {
  Progress progress;
  Fairing fairing(bolt(), {}, progress);
  for (const double weight : {0.0, -1.0, std::nan("")}) CHECK_THROWS_AS(fairing.solve(weight, progress), Error);
  std::atomic<bool> stop = true;
  Progress stopped({}, &stop);
  CHECK_THROWS_AS(fairing.solve(1, stopped), Cancelled);
  CHECK_THROWS_AS(Fairing(bolt(), {}, stopped), Cancelled);
}
