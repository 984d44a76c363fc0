// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

HoleAnalysis analyse(const PolyMesh& mesh) {
  Progress progress;
  return analyse_holes(mesh, progress);
}

std::vector<std::string> codes_of(const HoleAnalysis& analysis) {
  std::vector<std::string> codes;
  for (const Finding& finding : analysis.warnings) codes.push_back(finding.code);
  return codes;
}

std::set<std::set<Index>> loops_of(const HoleAnalysis& analysis) {
  std::set<std::set<Index>> loops;
  for (const Hole& hole : analysis.holes) loops.emplace(hole.vertices.begin(), hole.vertices.end());
  return loops;
}

}  // namespace

TEST_CASE("as many holes are found as were cut, with the rims that the topology has") {
  const std::vector<PolyMesh> shapes = {round_sphere(4), ring_torus(60, 30), divided_box(14), uv_sphere(40, 30),
                                        torus(50, 24)};
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(8, 100)); ++seed) {
    for (const PolyMesh& shape : shapes) {
      const CutScan scan = random_cuts(shape, seed, 1 + seed % 6, 0.1, 0.3);
      const HoleAnalysis analysis = analyse(scan.mesh);
      CHECK(analysis.holes.size() == scan.removed.size());
      CHECK(analysis.warnings.empty());
      const MeshTopology topology(scan.mesh);
      std::set<std::set<Index>> expected;
      for (std::size_t i = 0; i < topology.boundary_loops().size(); ++i) {
        const auto loop = topology.boundary_loops()[i];
        expected.emplace(loop.begin(), loop.end());
      }
      CHECK(loops_of(analysis) == expected);
    }
  }
}

TEST_CASE("rims run with the faces, start at their lowest vertex and are numbered by it") {
  const HoleAnalysis analysis = analyse(random_cuts(round_sphere(4), 2, 6, 0.1, 0.3).mesh);
  REQUIRE(analysis.holes.size() == 6);
  for (std::size_t i = 0; i < analysis.holes.size(); ++i) {
    const Hole& hole = analysis.holes[i];
    CHECK(hole.id == i);
    CHECK(*std::min_element(hole.vertices.begin(), hole.vertices.end()) == hole.vertices.front());
    if (i > 0) CHECK(analysis.holes[i - 1].vertices.front() < hole.vertices.front());
    for (std::size_t k = 0; k < hole.vertices.size(); ++k) {
      CHECK(analysis.view.origin(hole.corners[k]) == hole.vertices[k]);
      CHECK(analysis.view.target(hole.corners[k]) == hole.vertices[(k + 1) % hole.vertices.size()]);
      CHECK(analysis.view.opposite[hole.corners[k]] == no_index);
    }
  }
}

TEST_CASE("a round hole has the measures of a polygon in a circle") {
  const double radius = 0.3;
  const auto segments = Index{48};
  std::vector<Vec2> profile = {{2, 0}, {1, 0}, {radius, 0}};  // a disc seen from below: faces look down
  const PolyMesh mesh = revolved(profile, segments);
  const HoleAnalysis analysis = analyse(mesh);
  REQUIRE(analysis.holes.size() == 2);
  const Hole& hole = analysis.holes[1];
  const double step = std::numbers::pi / segments;
  CHECK(hole.perimeter == Approx(2 * segments * radius * std::sin(step)));
  CHECK(hole.diameter == Approx(2 * radius));
  CHECK(hole.area == Approx(segments * radius * radius * std::sin(step) * std::cos(step)));
  CHECK(hole.area_is_minimal);
  CHECK(hole.planarity < 1e-12);
  CHECK(hole.centre.norm() < 1e-12);
  CHECK(hole.rim_normals.angle < 1e-7);
  CHECK((hole.normal - hole.rim_normals.axis).norm() < 1e-12);
  CHECK(hole.conormal_tilt == Approx(std::numbers::pi / 2));
}

TEST_CASE("conormals lead out of the surface") {
  const HoleAnalysis analysis = analyse(open_tube(1, 3, 24, 6));
  REQUIRE(analysis.holes.size() == 2);
  CHECK((analysis.holes[0].conormal - Vec3(0, 0, -1)).norm() < 1e-9);
  CHECK((analysis.holes[1].conormal - Vec3(0, 0, 1)).norm() < 1e-9);
  CHECK((analysis.holes[0].normal - Vec3(0, 0, -1)).norm() < 1e-9);
}

TEST_CASE("measures follow scale, and lose nothing far from the origin") {
  const PolyMesh mesh = random_cuts(round_sphere(4), 7, 4, 0.1, 0.4).mesh;
  const HoleAnalysis near = analyse(mesh);
  const HoleAnalysis large = analyse(scaled(mesh, 1000));
  const HoleAnalysis far = analyse(translated(mesh, Vec3(1e6, -2e6, 3e6)));
  REQUIRE(near.holes.size() == 4);
  REQUIRE(far.holes.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(large.holes[i].perimeter == Approx(1000 * near.holes[i].perimeter).epsilon(1e-12));
    CHECK(large.holes[i].area == Approx(1e6 * near.holes[i].area).epsilon(1e-9));
    CHECK(far.holes[i].diameter == Approx(near.holes[i].diameter).epsilon(1e-8));
    CHECK(far.holes[i].area == Approx(near.holes[i].area).epsilon(1e-7));
    CHECK(far.holes[i].kind == near.holes[i].kind);
    CHECK(far.holes[i].vertices == near.holes[i].vertices);
  }
}

TEST_CASE("how a surface lies in space doesn't change its size") {
  Random random(5);
  for (const ScanKind kind : {ScanKind::Statue, ScanKind::Pot, ScanKind::Face, ScanKind::Part, ScanKind::Bones}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const PolyMesh mesh = known_scan(kind, seed, 3000).mesh;
      const Vec3 axis(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1));
      const HoleAnalysis plain = analyse(mesh);
      const HoleAnalysis turned = analyse(rotated(mesh, random.between(0, 6), axis.normalized()));
      CAPTURE(name_of(kind), seed);
      REQUIRE(turned.component_size.size() == plain.component_size.size());
      for (std::size_t c = 0; c < plain.component_size.size(); ++c)
        CHECK(turned.component_size[c] == Approx(plain.component_size[c]).epsilon(1e-6));
    }
  }
}

TEST_CASE("the size by the spread of area is 1.2 times the diagonal of the box around sheets, rods and spheres") {
  CHECK(analyse(sheet(60, 20)).component_size.front() == Approx(1.2 * std::hypot(60, 20)).epsilon(1e-3));
  CHECK(analyse(round_sphere(5)).component_size.front() == Approx(1.2 * 2 * std::sqrt(3.0)).epsilon(1e-3));
  CHECK(analyse(open_tube(0.1, 20, 24, 400)).component_size.front() == Approx(1.2 * 20).epsilon(1e-3));
}

TEST_CASE("the greatest distance is that of all pairs") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    const Index count = 2 + random.below(400);
    for (Index i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const double noise = seed % 3 == 0 ? 0 : 0.1 * random.unit();
      points.emplace_back((1 + noise) * std::cos(angle), std::sin(angle), seed % 2 == 0 ? 0 : random.unit());
    }
    double expected = 0;
    for (const Vec3& a : points) {
      for (const Vec3& b : points) expected = std::max(expected, (a - b).norm());
    }
    CHECK(greatest_distance(points) == expected);
  }
  CHECK(greatest_distance({}) == 0);
}

TEST_CASE("holes that share vertices are cut apart") {
  for (const Index count : {2u, 3u, 5u, 9u}) {
    const HoleAnalysis analysis = analyse(chained_holes(count));
    REQUIRE(analysis.holes.size() == count + 1);  // and the border
    std::size_t bow_ties = 0;
    for (const Hole& hole : analysis.holes) {
      CHECK(std::set<Index>(hole.vertices.begin(), hole.vertices.end()).size() == hole.vertices.size());
      if (hole.kind != HoleClass::BowTie) continue;
      ++bow_ties;
      CHECK(hole.vertices.size() == 4);
      CHECK(hole.area == Approx(1));
    }
    CHECK(bow_ties == count);
    CHECK(codes_of(analysis) == std::vector<std::string>{"W_BOWTIE"});
  }
}

TEST_CASE("a triangle that hangs in a hole by its corners divides it") {
  // Three neighbours of a triangle are missing: it touches the rest in its corners alone.
  PolyMesh mesh = sheet(6, 6);
  const MeshTopology topology(mesh);
  const Index middle = 30;
  std::vector<Index> missing;
  for (Index corner = 3 * middle; corner < 3 * middle + 3; ++corner)
    missing.push_back(topology.face(topology.opposite(corner)));
  const HoleAnalysis analysis = analyse(without_faces(mesh, missing));
  REQUIRE(analysis.holes.size() == 4);
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(analysis.holes[i].vertices.size() == 3);
    CHECK(analysis.holes[i].kind == HoleClass::BowTie);
  }
}

TEST_CASE("edges of many faces are no rims, and rims that end there are reported") {
  // Three sheets on one edge: each has a border that ends at the edge's ends, where the next one takes over.
  PolyMesh book;
  book.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
  for (const Index page : {2u, 4u, 6u}) {
    book.add_triangle(0, page, page + 1);
    book.add_triangle(0, page + 1, 1);
  }
  const HoleAnalysis analysis = analyse(book);
  CHECK(analysis.view.nonmanifold_edges == 1);
  CHECK(analysis.open_rims == 3);
  CHECK(analysis.holes.empty());
  CHECK(codes_of(analysis) == std::vector<std::string>{"W_NONMANIFOLD"});

  const HoleAnalysis shut = analyse(tetrahedra_sharing_edge());
  CHECK(shut.holes.empty());
  CHECK(shut.open_rims == 0);
}

TEST_CASE("the rim of a band with half a turn is one loop, marked as ambiguous") {
  const HoleAnalysis analysis = analyse(moebius(9));
  REQUIRE(analysis.holes.size() == 1);
  CHECK(analysis.holes[0].vertices.size() == 18);
  CHECK(analysis.holes[0].ambiguous);
  CHECK(codes_of(analysis) == std::vector<std::string>{"W_ORIENTATION"});
}

TEST_CASE("a closed mesh has no holes and nothing to say") {
  for (const PolyMesh& mesh : {cube(), round_sphere(2), double_torus(), shell(2, 0.1)}) {
    const HoleAnalysis analysis = analyse(mesh);
    CHECK(analysis.holes.empty());
    CHECK(analysis.warnings.empty());
  }
}

TEST_CASE("dirt of every kind is reported by its code, and the holes are found all the same") {
  const PolyMesh clean = random_cuts(round_sphere(3), 4, 3, 0.2, 0.35).mesh;
  PolyMesh dirty = as_soup(flipped_face(clean, 40));
  dirty.add_triangle(9, 9, 10);
  const HoleAnalysis analysis = analyse(dirty);
  CHECK(analysis.holes.size() == 3);
  CHECK(codes_of(analysis) == std::vector<std::string>{"W_WELDED", "W_ORIENTATION", "W_DEGENERATE"});
  REQUIRE(analysis.warnings[1].subjects.size() == 1);
  CHECK(analysis.warnings[1].subjects[0].index == 40);
}

TEST_CASE("rims of seams use the vertex that their faces share") {
  // Two columns of quads that meet along a seam of doubled vertices; the hole lies beside the seam on both sides.
  PolyMesh left = without_faces(grid(4, 8), std::vector<Index>{15, 19});
  const PolyMesh right = translated(without_faces(grid(4, 8), std::vector<Index>{12, 16}), Vec3(4, 0, 0));
  const HoleAnalysis analysis = analyse(merged(left, right));
  REQUIRE(analysis.holes.size() == 2);
  CHECK(analysis.view.component_count == 1);
  const auto half = static_cast<Index>(left.vertex_count());
  for (const Index v : analysis.holes[1].vertices) {
    const bool on_right = v >= half;
    const double x = merged(left, right).positions[v].x();
    CHECK((x < 4 ? !on_right : x > 4 ? on_right : true));
  }
}

TEST_CASE("an analysis can be cancelled, and its progress reaches the end") {
  const PolyMesh mesh = random_cuts(round_sphere(4), 1, 5, 0.1, 0.2).mesh;
  const std::atomic<bool> cancel = true;
  Progress stopped({}, &cancel);
  CHECK_THROWS_AS(analyse_holes(mesh, stopped), Cancelled);
  double last = 0;
  Progress progress([&](double fraction, const std::string&) {
    CHECK(fraction >= last);
    last = fraction;
  });
  analyse_holes(mesh, progress);
  CHECK(last == 1);
}
