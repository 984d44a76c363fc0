// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/hole_filling/hole_groups.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

std::vector<std::vector<Index>> groups_of(const PolyMesh& mesh) {
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  return group_holes(mesh, analysis.holes).lists();
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

TEST_CASE("a hole and its island are one group though their flat rims' own boxes are apart") {
  // The cap's rim and the hole's rim lie in parallel planes: boxes grown per axis would never meet.
  CHECK(groups_of(cut_ring(round_sphere(5), Vec3(0, 0, 1), 0.25, 0.6).mesh) == std::vector<std::vector<Index>>{{0, 1}});
}

TEST_CASE("holes far from each other are groups of their own") {
  const PolyMesh one = cut(round_sphere(5), Vec3(0, 0, 1), 0.3).mesh;
  CHECK(groups_of(cut(one, Vec3(0, 0, -1), 0.3).mesh).size() == 2);
}

TEST_CASE("both skins of a thin shell stay apart") {
  const PolyMesh outer_cut = cut(shell(5, 0.03), Vec3(0, 0, 1), 0.3).mesh;
  CHECK(groups_of(cut(outer_cut, Vec3(0, 0, 0.97), 0.2).mesh).size() == 2);
}

TEST_CASE("borders and holes that aren't chosen are in no one's group") {
  const PolyMesh mesh = cut(cut(sheet(12, 12), Vec3(4, 6, 0), 1.8).mesh, Vec3(8, 6, 0), 1.8).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  REQUIRE(analysis.holes.size() == 3);
  CHECK(group_holes(mesh, analysis.holes).lists() == std::vector<std::vector<Index>>{{0}, {1, 2}});
  CHECK(group_holes(mesh, analysis.holes, {true, true, false}).lists().size() == 3);
}

TEST_CASE("groups can be merged later, in any order, with the same result") {
  HoleGroups one(6), other(6);
  one.merge(4, 2), one.merge(5, 0), one.merge(2, 5);
  other.merge(5, 2), other.merge(0, 2), other.merge(4, 0);
  CHECK(one.lists() == std::vector<std::vector<Index>>{{0, 2, 4, 5}, {1}, {3}});
  CHECK(one.lists() == other.lists());
  CHECK(one.group(5) == 0);
}
