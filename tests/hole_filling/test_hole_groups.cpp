// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "croquis/geometry/disjoint_sets.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// Holes of a mesh that one sheet could join.
std::vector<std::array<Index, 2>> joinable_pairs(const PolyMesh& mesh) {
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  std::vector<std::array<Index, 2>> pairs = near_pairs(mesh, analysis.holes);
  std::erase_if(pairs,
                [&](const auto& pair) { return !are_compatible(analysis.holes[pair[0]], analysis.holes[pair[1]]); });
  return pairs;
}

/// Triangles of random places and sizes as rims.
std::vector<Hole> random_rims(PolyMesh& mesh, std::uint64_t seed, Index count) {
  Random random(seed);
  std::vector<Hole> holes(count);
  for (Index id = 0; id < count; ++id) {
    const double x = random.unit(), y = random.unit();
    const Vec3 at(x, y, random.unit());
    const double size = random.between(0.001, 0.2);
    holes[id].id = id;
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(0, size, size)}) {
      holes[id].vertices.push_back(static_cast<Index>(mesh.positions.size()));
      mesh.positions.push_back(at + offset);
    }
    holes[id].diameter = std::sqrt(3.0) * size;
    holes[id].rim_normals.axis = id % 3 == 0 ? Vec3(0, 0, -1) : Vec3(0, 0, 1);
  }
  return holes;
}

}  // namespace

TEST_CASE("near pairs are those of a search of all pairs") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    PolyMesh mesh;
    const std::vector<Hole> holes = random_rims(mesh, seed, 80);
    std::vector<Eigen::AlignedBox3d> boxes(holes.size());
    for (std::size_t i = 0; i < holes.size(); ++i) {
      for (const Index v : holes[i].vertices) {
        boxes[i].extend(Vec3(mesh.positions[v] + Vec3::Constant(holes[i].diameter / 2)));
        boxes[i].extend(Vec3(mesh.positions[v] - Vec3::Constant(holes[i].diameter / 2)));
      }
    }
    std::vector<std::array<Index, 2>> expected;
    for (Index a = 0; a < holes.size(); ++a) {
      for (Index b = a + 1; b < holes.size(); ++b) {
        if (boxes[a].intersects(boxes[b])) expected.push_back({a, b});
      }
    }
    CHECK(near_pairs(mesh, holes) == expected);
    CHECK(expected.size() > 20);
  }
}

TEST_CASE("a hole and its island are near though their flat rims' own boxes are apart") {
  // The cap's rim and the hole's rim lie in parallel planes: boxes grown per axis would never meet.
  CHECK(joinable_pairs(cut_ring(round_sphere(5), Vec3(0, 0, 1), 0.25, 0.6).mesh) ==
        std::vector<std::array<Index, 2>>{{0, 1}});
}

TEST_CASE("both skins of a thin shell stay apart") {
  const PolyMesh outer_cut = cut(shell(5, 0.03), Vec3(0, 0, 1), 0.3).mesh;
  CHECK(joinable_pairs(cut(outer_cut, Vec3(0, 0, 0.97), 0.2).mesh).empty());
}

TEST_CASE("holes are joined in any order, with the same groups") {
  DisjointSets one(6), other(6);
  one.unite(4, 2), one.unite(5, 0), one.unite(2, 5);
  other.unite(5, 2), other.unite(0, 2), other.unite(4, 0);
  CHECK(one.lists() == std::vector<std::vector<Index>>{{0, 2, 4, 5}, {1}, {3}});
  CHECK(one.lists() == other.lists());
  CHECK(one.root(5) == 0);
}
