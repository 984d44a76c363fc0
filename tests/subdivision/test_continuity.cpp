// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/subdivision/continuity.h"
#include "croquis/subdivision/shape_keeping.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

template <typename Result>
ContinuityReport report_of(const Result& result) {
  Progress progress;
  return continuity_report(result.plan, result.points, progress);
}

std::vector<double> angles(const ContinuityReport& report) {
  std::vector<double> result;
  for (std::size_t k = 1; k < report.levels.size(); ++k) result.push_back(degrees(report.levels[k].greatest_bend));
  return result;
}

void check_angles(const PolyMesh& cage, const std::vector<double>& expected) {
  const std::vector<double> measured = angles(report_of(refined(cage, static_cast<int>(expected.size()))));
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(measured[i] == Approx(expected[i]).margin(0.005));
}

}  // namespace

TEST_CASE("Greatest angles of the bolt's loop, the cube's loop and the bolt's open chain, level by level") {
  check_angles(bolt_loop(), {75.96, 53.13, 29.74, 14.93, 7.62});
  check_angles(cube_top_loop(), {63.43, 36.70, 21.87, 12.68, 7.02});
  check_angles(bolt_open_chain(), {75.96, 53.13, 31.89, 24.21, 17.66});
}

TEST_CASE("Verdicts: halving beside a loop, fading at a smooth end, a kink where a chain retracts") {
  const ContinuityReport loop = report_of(refined(bolt_loop(), 5));
  CHECK(loop.verdict == Smoothness::Halving);
  CHECK(loop.sentence.starts_with("G1 (halving): 7.62 degrees"));
  CHECK(report_of(refined(bolt_open_chain(), 5)).verdict == Smoothness::Fading);
  CHECK(report_of(refined(grid(4, 3), 3)).verdict == Smoothness::Flat);
  CHECK(report_of(refined(bolt(), 1)).verdict == Smoothness::Unknown);

  const ContinuityReport paper = report_of(refined(bolt_open_chain(), 5, Rules::of(Preset::Paper)));
  CHECK(paper.verdict == Smoothness::Kink);
  CHECK(paper.sentence.starts_with("kink at edge "));
  for (std::size_t k = 1; k < paper.levels.size(); ++k) {
    CHECK(degrees(paper.levels[k].greatest_bend) > 71);
    CHECK(degrees(paper.levels[k].greatest_bend) < 77);
  }
  // Near the middle of the chain's first or last edge, where it has drawn back to.
  const Vec3 place = paper.levels.back().place;
  const std::vector<Vec3> cage = bolt().positions;
  const std::vector<Vec3> middles = {(cage[8] + cage[9]) / 2, (cage[10] + cage[11]) / 2};
  CHECK(greatest_gap({&place, 1}, middles) < 0.1);
}

TEST_CASE("Pinned corners of a loop leave a cone beside them, and the verdict names it") {
  PolyMesh cage = bolt_loop();
  cage.tags.pins = {8, 9, 10, 11};
  const ContinuityReport report = report_of(refined(cage, 5));
  CHECK(report.verdict == Smoothness::Kink);
  const std::vector<Vec3> corners(cage.positions.begin() + 8, cage.positions.begin() + 12);
  CHECK(greatest_gap({&report.levels.back().place, 1}, corners) < 0.05);
}

TEST_CASE("While sharpness runs out there is no verdict, afterwards angles halve") {
  const PolyMesh cage = tagged(centred_cube(), all_edges(centred_cube()), 1.5);
  CHECK(report_of(refined(cage, 2)).verdict != Smoothness::Kink);
  for (const int levels : {3, 4}) CHECK(report_of(refined(cage, levels)).verdict != Smoothness::Kink);
  CHECK(report_of(refined(cage, 7)).verdict == Smoothness::Halving);
}

TEST_CASE("Catmull-Clark halves its angles too") {
  CHECK(report_of(uniformly_refined(bolt_loop(), 5)).verdict == Smoothness::Halving);
  CHECK(report_of(uniformly_refined(cube_all_sharp(), 4)).verdict == Smoothness::Flat);
}

TEST_CASE("An angle that comes back after a flat level is a kink") {
  const ContinuityReport report = report_of(uniformly_refined(back_to_back(4), 2));
  REQUIRE(report.levels[1].greatest_bend < 1e-6);
  REQUIRE(report.levels[2].greatest_bend > 3);
  CHECK(report.verdict == Smoothness::Kink);
}

TEST_CASE("Angles left over beside a chain halve on both sides, and the one across stays") {
  std::vector<ChainShape> shapes;
  for (const int levels : {3, 4, 5}) {
    const ContinuityReport report = report_of(refined(bolt_loop(), levels));
    REQUIRE(report.shapes.size() == 1);
    shapes.push_back(report.shapes[0]);
  }
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    CHECK(shapes[1].side_bends[side] <= 0.62 * shapes[0].side_bends[side] + 1e-12);
    CHECK(shapes[2].side_bends[side] <= 0.62 * shapes[1].side_bends[side] + 1e-12);
  }
  // The underside is flat, the shank is round.
  CHECK(std::min(shapes[2].side_bends[0], shapes[2].side_bends[1]) < 1e-9);
  CHECK(std::max(shapes[2].side_bends[0], shapes[2].side_bends[1]) > 0.01);
  CHECK(degrees(shapes[2].least_bend) == Approx(90).margin(1e-9));
}

TEST_CASE("Bends of all edges: a cube has twelve right angles, a boundary none") {
  const Refined cube = refined(centred_cube(), 0);
  for (const double bend : edge_bends(cube.plan.level(0), cube.at(0))) CHECK(degrees(bend) == Approx(90));
  const Refined open = refined(grid(2, 2), 0);
  for (const double bend : edge_bends(open.plan.level(0), open.at(0))) CHECK(bend == 0);
}
