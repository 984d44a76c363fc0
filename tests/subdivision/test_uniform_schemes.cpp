// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/subdivision/level_mesh.h"
#include "croquis/subdivision/uniform_schemes.h"
#include "subdivision/cgal_subdivision.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

constexpr UniformRules loop_rules{UniformScheme::Loop, BoundaryCorners::Corner};

bool is_closed(const PolyMesh& mesh) { return MeshTopology(mesh).boundary_loops().size() == 0; }

long euler(const HalfEdges& mesh) {
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(mesh.edge_count()) +
         static_cast<long>(mesh.face_count());
}

void require_half_edges(const HalfEdges& mesh) {
  const CornerFaces around(mesh);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    const Index twin = mesh.twin[corner];
    if (twin == no_index) continue;
    REQUIRE(mesh.twin[twin] == corner);
    REQUIRE(mesh.corner_edge[twin] == mesh.corner_edge[corner]);
    REQUIRE(mesh.corner_vertex[twin] == mesh.corner_vertex[around.next(corner)]);
  }
  std::vector<std::size_t> turned(mesh.vertex_count(), 0), corners(mesh.vertex_count(), 0);
  for (const Index vertex : mesh.corner_vertex) ++corners[vertex];
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    const Index start = mesh.vertex_corner[vertex];
    Index corner = start;
    do {
      ++turned[vertex];
      corner = mesh.twin[around.previous(corner)];
    } while (corner != no_index && corner != start);
  }
  REQUIRE(turned == corners);
}

}  // namespace

TEST_CASE("Catmull-Clark of untagged closed meshes is CGAL's to twelve digits") {
  for (const NamedCage& cage : all_cages()) {
    if (!is_closed(cage.mesh) || cage.name.find("back") != std::string::npos) continue;
    INFO(cage.name);
    const UniformRefined ours = uniformly_refined(cage.mesh, 2);
    const std::vector<Vec3> theirs = cgal_catmull_clark(cage.mesh, 2);
    REQUIRE(ours.at(2).size() == theirs.size());
    CHECK(greatest_gap(ours.at(2), theirs) < 1e-12 * extent(theirs));
    CHECK(greatest_gap(theirs, ours.at(2)) < 1e-12 * extent(theirs));
  }
}

TEST_CASE("Loop of closed triangle meshes is CGAL's to twelve digits") {
  for (const PolyMesh& mesh : {icosahedron(), triangulated(bolt()), triangulated(torus(7, 5)), tetrahedron()}) {
    const UniformRefined ours = uniformly_refined(mesh, 2, loop_rules);
    const std::vector<Vec3> theirs = cgal_loop(mesh, 2);
    CHECK(ours.plan.warnings().empty());
    REQUIRE(ours.at(2).size() == theirs.size());
    CHECK(greatest_gap(ours.at(2), theirs) < 1e-12 * extent(theirs));
  }
}

TEST_CASE("Levels of both schemes are manifold, keep the Euler number and have the counts computed before") {
  for (const NamedCage& cage : all_cages()) {
    for (const UniformRules& rules : {UniformRules{}, loop_rules}) {
      INFO(cage.name << (rules.scheme == UniformScheme::Loop ? ", Loop" : ", Catmull-Clark"));
      const UniformRefined result = uniformly_refined(cage.mesh, 2, rules);
      for (int k = 0; k <= 2; ++k) {
        const HalfEdges& mesh = result.plan.level(k).topology;
        require_half_edges(mesh);
        REQUIRE(result.at(k).size() == mesh.vertex_count());
        REQUIRE(euler(mesh) == euler(result.plan.level(0).topology));
        if (k == 0) continue;
        const HalfEdges& before = result.plan.level(k - 1).topology;
        const bool loop = rules.scheme == UniformScheme::Loop;
        REQUIRE(mesh.face_count() == (loop ? 4 * before.face_count() : before.corner_count()));
        REQUIRE(mesh.vertex_count() == before.vertex_count() + before.edge_count() + (loop ? 0 : before.face_count()));
      }
    }
  }
}

TEST_CASE("Weights of all levels sum to one and give the points") {
  const UniformRefined result = uniformly_refined(bolt_open_chain(), 3);
  for (int k = 1; k <= 3; ++k) {
    const auto weights = result.plan.weights(k);
    const Eigen::VectorXd sums = weights * Eigen::VectorXd::Ones(weights.cols());
    CHECK((sums.array() - 1).abs().maxCoeff() < 1e-14);
    Eigen::MatrixX3d before(weights.cols(), 3);
    for (Eigen::Index i = 0; i < before.rows(); ++i) before.row(i) = result.at(k - 1)[static_cast<std::size_t>(i)];
    const Eigen::MatrixX3d after = weights * before;
    double gap = 0;
    for (Eigen::Index i = 0; i < after.rows(); ++i) {
      gap = std::max(gap, (after.row(i).transpose() - result.at(k)[static_cast<std::size_t>(i)]).norm());
    }
    CHECK(gap < 1e-14);
  }
}

TEST_CASE("A closed chain of t edges has 2t, 4t, … at later levels in all three schemes") {
  for (const PolyMesh& mesh : {bolt_loop(), cube_top_loop()}) {
    const Refined doo_sabin = refined(mesh, 4);
    const UniformRefined catmull_clark = uniformly_refined(mesh, 4);
    const UniformRefined loop = uniformly_refined(mesh, 4, loop_rules);
    std::size_t count = 4;
    for (int k = 0; k <= 4; ++k, count *= 2) {
      CHECK(doo_sabin.plan.level(k).sharp.size() == count);
      CHECK(catmull_clark.plan.level(k).sharp.size() == count);
      CHECK(loop.plan.level(k).sharp.size() == count);
    }
  }
}

TEST_CASE("A cube whose edges are all sharp stays that cube in all three schemes") {
  const PolyMesh cage = cube_all_sharp();
  const auto on_cube = [](const Vec3& p) { return std::abs(p.cwiseAbs().maxCoeff() - 1) < 1e-14; };
  const Refined doo_sabin = refined(cage, 3);
  CHECK(std::all_of(doo_sabin.at(3).begin(), doo_sabin.at(3).end(), on_cube));
  for (const UniformRules& rules : {UniformRules{}, loop_rules}) {
    const UniformRefined result = uniformly_refined(cage, 3, rules);
    CHECK(std::all_of(result.at(3).begin(), result.at(3).end(), on_cube));
    CHECK(greatest_gap(cage.positions, result.at(3)) == 0);
  }
}

TEST_CASE("Sharpness counts down by one per level and infinite sharpness stays") {
  PolyMesh cage = bolt();
  cage.tags.creases = {{{8, 9}, 2.5}, {{10, 11}, infinite_sharpness}, {{0, 1}, 1}};
  const UniformRefined result = uniformly_refined(cage, 3);
  const std::vector<std::map<double, int>> expected = {{{1, 1}, {2.5, 1}, {infinite_sharpness, 1}},
                                                       {{1.5, 2}, {infinite_sharpness, 2}},
                                                       {{0.5, 4}, {infinite_sharpness, 4}},
                                                       {{infinite_sharpness, 8}}};
  for (int k = 0; k <= 3; ++k) {
    std::map<double, int> counts;
    for (const SharpEdge& sharp : result.plan.level(k).sharp) ++counts[sharp.sharpness];
    CHECK(counts == expected[static_cast<std::size_t>(k)]);
  }
}

TEST_CASE("Pins stay where they are, and are named at every level") {
  PolyMesh cage = bolt_loop();
  cage.tags.pins = {3, 9};
  for (const UniformRules& rules : {UniformRules{}, loop_rules}) {
    const UniformRefined result = uniformly_refined(cage, 3, rules);
    for (int k = 0; k <= 3; ++k) {
      const std::vector<Index>& pins = result.plan.level(k).pins;
      REQUIRE(pins.size() == 2);
      for (const Index pin : pins) CHECK(greatest_gap({&result.at(k)[pin], 1}, cage.positions) == 0);
    }
  }
}

TEST_CASE("Boundary corners stay or are rounded as asked") {
  const PolyMesh cage = grid(3, 2);
  const Vec3 corner = cage.positions[0];
  for (const UniformScheme scheme : {UniformScheme::CatmullClark, UniformScheme::Loop}) {
    const UniformRefined kept = uniformly_refined(cage, 3, {scheme, BoundaryCorners::Corner});
    const UniformRefined round = uniformly_refined(cage, 3, {scheme, BoundaryCorners::Smooth});
    if (scheme == UniformScheme::CatmullClark) CHECK(greatest_gap({&corner, 1}, kept.at(3)) == 0);
    CHECK(greatest_gap({&corner, 1}, round.at(3)) > 0.1);
  }
}

TEST_CASE("Loop cuts polygons by connectivity alone and says how many") {
  const PolyMesh cage = house();
  PolyMesh moved = cage;
  for (Vec3& p : moved.positions) p = Vec3(p.x() * 3 + p.y(), p.y() - 2 * p.z(), p.x() * p.z());
  Progress progress;
  const UniformPlan plan(make_cage(cage).cage, loop_rules, 1, progress);
  const UniformPlan moved_plan(make_cage(moved).cage, loop_rules, 1, progress);
  CHECK(plan.level(1).topology.corner_vertex == moved_plan.level(1).topology.corner_vertex);
  REQUIRE(plan.warnings().size() == 1);
  CHECK(plan.warnings()[0].code == "W_TRIANGULATED");
  CHECK(plan.warnings()[0].message.starts_with("7 faces"));
  for (Index face = 0; face < plan.level(1).topology.face_count(); ++face) {
    CHECK(plan.cage_face(1, face) < cage.face_count());
  }
}

TEST_CASE("Two polygons back to back, which leave no free diagonals, are cut for Loop all the same") {
  for (const Index sides : {Index{3}, Index{4}, Index{5}, Index{8}}) {
    const UniformRefined result = uniformly_refined(back_to_back(sides), 2, loop_rules);
    require_half_edges(result.plan.level(0).topology);
    CHECK(euler(result.plan.level(0).topology) == 2);
    for (std::size_t f = 0; f < result.plan.level(0).topology.face_count(); ++f) {
      CHECK(result.plan.level(0).topology.face(f).size() == 3);
    }
  }
}

TEST_CASE("Too many faces are refused beforehand with the counts") {
  Progress progress;
  const Cage cage = make_cage(bolt()).cage;
  try {
    const UniformPlan plan(cage, {}, Depth(9, 100'000), progress);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 1);
    CHECK(error.findings()[0].code == "E_TOO_MANY_FACES");
    CHECK(error.findings()[0].category == Category::Limit);
    const std::string counts = "Level 7 would have 229376 faces, 458752 edges and 229378 vertices";
    CHECK(error.findings()[0].message.starts_with(counts));
  }
  CHECK_THROWS_AS(UniformPlan(cage, {}, 40, progress), Error);
}

TEST_CASE("What OpenSubdiv can't refine is reported in its own words") {
  Progress progress;
  const Cage cage = make_cage(single_face(70'000)).cage;
  try {
    const UniformPlan plan(cage, {}, 1, progress);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.findings()[0].code == "E_SUBDIVISION");
    CHECK(error.findings()[0].message.size() > 60);
  }
  CHECK(uniformly_refined(bolt(), 1).at(1).size() == 58);  // and the next mesh is refined as ever
}

TEST_CASE("The same bits for any number of threads") {
  const PolyMesh cage = torus(30, 20);
  Progress progress;
  const Cage made = make_cage(cage).cage;
  const UniformPlan plan(made, {}, 3, progress);
  PositionBuffers one, four;
  plan.positions(made.positions, one, 1);
  plan.positions(made.positions, four, 4);
  CHECK(one.levels == four.levels);
}

TEST_CASE("A level of Catmull-Clark goes on where it stopped") {
  PolyMesh cage = bolt_loop();
  cage.tags.creases.push_back({{0, 1}, 2.5});
  cage.tags.pins = {12};
  const UniformRefined whole = uniformly_refined(cage, 3);
  const PolyMesh level = to_mesh(whole.plan, 1, whole.at(1));
  const UniformRefined rest = uniformly_refined(level, 2);
  REQUIRE(rest.at(2).size() == whole.at(3).size());
  CHECK(greatest_gap(rest.at(2), whole.at(3)) < 1e-14);
  REQUIRE(level.channel("cage_element", Domain::Face) != nullptr);
}

TEST_CASE("A cage without faces has levels without faces, and a raised flag stops the plan") {
  CHECK(uniformly_refined(PolyMesh{}, 3).at(3).empty());
  std::atomic<bool> stop = true;
  Progress progress({}, &stop);
  const Cage cage = make_cage(bolt()).cage;
  CHECK_THROWS_AS(UniformPlan(cage, {}, 3, progress), Cancelled);
}
