// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/subdivision/doo_sabin.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

using subdivision::BoundaryCorners;
using subdivision::ChainEnds;
using subdivision::DooSabinPlan;
using subdivision::HalfEdges;
using subdivision::Level;
using subdivision::Preset;
using subdivision::Profile;
using subdivision::Rules;
using subdivision::Weights;

constexpr double relative = 1e-8;

Approx near(double value) { return Approx(value).epsilon(relative).margin(1e-12); }

struct Figures {
  Counts counts;
  std::size_t tags;
  std::map<std::size_t, std::size_t> sizes;
  double squares_paper, squares_refined, volume_paper, volume_refined;
};

void check_figures(const PolyMesh& mesh, const std::vector<Figures>& expected) {
  const int levels = static_cast<int>(expected.size()) - 1;
  for (const Preset preset : {Preset::Paper, Preset::Refined}) {
    const bool paper = preset == Preset::Paper;
    const Subdivided result = subdivide(mesh, levels, Rules::of(preset));
    for (int k = 0; k <= levels; ++k) {
      const Figures& figures = expected[static_cast<std::size_t>(k)];
      INFO((paper ? "paper" : "refined") << ", level " << k);
      CHECK(fault(result.topology(k)) == "");
      CHECK(counts(result.topology(k)) == figures.counts);
      CHECK(result.plan.level(k).sharp.size() == figures.tags);
      CHECK(faces_by_size(result.topology(k)) == figures.sizes);
      CHECK(sum_of_squares(result.points(k)) == near(paper ? figures.squares_paper : figures.squares_refined));
      CHECK(volume(result.topology(k), result.points(k)) ==
            near(paper ? figures.volume_paper : figures.volume_refined));
    }
  }
}

TEST_CASE("the screw with a loop of four sharp edges has the known figures") {
  check_figures(
      bolt_loop(),
      {{{16, 28, 14}, 4, {{4, 14}}, 120, 120, 28, 28},
       {{48, 96, 50}, 8, {{3, 8}, {4, 42}}, 226.125, 195.5, 21.747395833, 20.364583333},
       {{176, 352, 178}, 16, {{3, 8}, {4, 170}}, 755.179361979, 634.8203125, 20.247599284, 18.778157552},
       {{672, 1344, 674}, 32, {{3, 8}, {4, 666}}, 2853.081011454, 2391.210571289, 19.872251948, 18.381401062},
       {{2624, 5248, 2626}, 64, {{3, 8}, {4, 2618}}, 11196.353925447, 9387.375146866, 19.77651029, 18.282333573},
       {{10368, 20736, 10370},
        128,
        {{3, 8}, {4, 10362}},
        44479.997332775,
        37305.299606234,
        19.752113622,
        18.257578436}});
}

TEST_CASE("the screw with an open chain of three sharp edges has the known figures") {
  check_figures(
      bolt_open_chain(),
      {{{16, 28, 14}, 3, {{4, 14}}, 120, 120, 28, 28},
       {{50, 101, 53}, 5, {{3, 10}, {4, 43}}, 231.15625, 209.1328125, 21.895833333, 21.276692708},
       {{192, 385, 195}, 9, {{3, 10}, {4, 185}}, 790.539550781, 707.389923096, 20.475059191, 19.885532697},
       {{752, 1505, 755}, 17, {{3, 10}, {4, 745}}, 3024.564304352, 2706.04689467, 20.135417497, 19.538402686},
       {{2976, 5953, 2979}, 33, {{3, 10}, {4, 2969}}, 11938.07306549, 10687.385343953, 20.05313804, 19.451670158},
       {{11840, 23681, 11843},
        65,
        {{3, 10}, {4, 11833}},
        47547.875980315,
        42579.012188193,
        20.033344884,
        19.429988028}});
}

TEST_CASE("a cube whose top is all sharp gets one band and has the known figures") {
  check_figures(
      cube_top_loop(),
      {{{8, 12, 6}, 4, {{4, 6}}, 24, 24, 8, 8},
       {{24, 48, 26}, 8, {{3, 8}, {4, 18}}, 42, 40, 6.333333333, 5.666666667},
       {{80, 160, 82}, 16, {{3, 8}, {4, 74}}, 115.076388889, 113.406550069, 5.911132812, 5.192708333},
       {{288, 576, 290}, 32, {{3, 8}, {4, 282}}, 381.165045091, 378.906653513, 5.802062882, 5.072998047},
       {{1088, 2176, 1090}, 64, {{3, 8}, {4, 1082}}, 1386.421233144, 1376.595954399, 5.773605211, 5.043047587},
       {{4224, 8448, 4226}, 128, {{3, 8}, {4, 4218}}, 5286.145823417, 5235.841674382, 5.766234055, 5.035560211}});
  const Subdivided result = subdivide(cube_top_loop(), 4);
  CHECK(result.plan.banded(1));
  for (int k = 2; k <= 4; ++k) CHECK_FALSE(result.plan.banded(k));
}

TEST_CASE("a ring of sharp edges through an icosahedron gets two faces on each side of every vertex") {
  // Around vertex 0: two faces of each vertex of the ring lie within it, three outside.
  const std::vector<VertexPair> ring = {{5, 11}, {1, 5}, {1, 7}, {7, 10}, {10, 11}};
  const Subdivided result = subdivide(tagged(icosahedron(), ring), 3);
  for (int k = 1; k <= 3; ++k) {
    const HalfEdges& mesh = result.topology(k);
    CHECK(fault(mesh) == "");
    const std::vector<Index> vertices = tagged_vertices(result.plan.level(k));
    CHECK(vertices.size() == std::size_t{5} << static_cast<unsigned>(k));
    for (const Index vertex : vertices) CHECK(std::ranges::count(mesh.corner_vertex, vertex) == 4);
  }
}

TEST_CASE("without tags counts grow as Doo and Sabin have it") {
  const std::vector<Counts> bolt_counts = {{16, 28, 14},     {56, 112, 58},      {224, 448, 226},
                                           {896, 1792, 898}, {3584, 7168, 3586}, {14336, 28672, 14338}};
  const Subdivided result = subdivide(bolt(), 5);
  for (int k = 0; k <= 5; ++k) {
    CHECK(counts(result.topology(k)) == bolt_counts[static_cast<std::size_t>(k)]);
    CHECK(fault(result.topology(k)) == "");
  }
  for (const NamedCage& cage : all_cages()) {
    const Subdivided any = subdivide(cage.mesh, 2);
    if (!any.plan.level(0).boundary.empty()) continue;
    for (int k = 0; k < 2; ++k) {
      INFO(cage.name << ", level " << k);
      const auto [v, e, f] = counts(any.topology(k));
      const std::size_t thin = any.plan.level(k).valence_two.size();
      CHECK(counts(any.topology(k + 1)) == Counts{2 * e, 4 * e - thin, v + e + f - thin});
    }
  }
}

TEST_CASE("a sharp loop keeps its right angle exactly, stays in its plane and becomes nearly a circle") {
  for (const Preset preset : {Preset::Paper, Preset::Refined}) {
    const Subdivided result = subdivide(bolt_loop(), 5, Rules::of(preset));
    for (int k = 0; k <= 5; ++k) {
      INFO("level " << k);
      const auto vertices = tagged_vertices(result.plan.level(k));
      CHECK(vertices.size() == std::size_t{4} << k);
      CHECK(std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return result.points(k)[v].z() == 0; }));
      double worst = 0;
      for (const auto& tag : result.plan.level(k).sharp) {
        worst = std::max(worst, std::abs(dihedral_degrees(result.topology(k), result.points(k), tag.edge) - 90));
      }
      CHECK(worst < 1e-9);
    }
    double smallest = 10, largest = 0;
    for (const Index v : tagged_vertices(result.plan.level(5))) {
      smallest = std::min(smallest, result.points(5)[v].norm());
      largest = std::max(largest, result.points(5)[v].norm());
    }
    CHECK(smallest >= 1.000488);
    CHECK(smallest < 1.0005);
    CHECK(largest <= 1.0608904);
    CHECK(largest > 1.0608);
  }
}

TEST_CASE("the row beside a crease halves when clamped and shrinks by three quarters when plain") {
  const auto row_width = [](Preset preset) {
    const Subdivided result = subdivide(bolt_loop(), 5, Rules::of(preset));
    const Level& level = result.plan.level(5);
    const subdivision::CornerFaces around(level.topology);
    double width = 10;
    for (const auto& tag : level.sharp) {
      const Index h = level.topology.edge_corner[tag.edge];
      for (const Index side : {h, level.topology.twin[h]}) {
        const auto& points = result.points(5);
        const auto at = [&](Index c) { return points[level.topology.corner_vertex[c]]; };
        const Index far = around.next(around.next(side));
        // On the underside, in the middle of a side of the square, rows run along the side.
        if (std::abs(at(far).z()) > 1e-12 || at(side).x() * at(around.next(side)).x() >= 0 || at(side).y() < 0)
          continue;
        width = std::min(width, std::abs(at(far).y() - at(side).y()));
      }
    }
    return width;
  };
  CHECK(row_width(Preset::Paper) == Approx(std::pow(0.75, 5)).epsilon(1e-9));
  CHECK(row_width(Preset::Refined) == Approx(std::pow(0.5, 5)).epsilon(1e-9));
}

TEST_CASE("the surface beside a crease gets smooth: angles halve") {
  const auto angles = [](const PolyMesh& mesh, Preset preset) {
    const Subdivided result = subdivide(mesh, 5, Rules::of(preset));
    std::vector<double> found;
    for (int k = 1; k <= 5; ++k) found.push_back(largest_untagged_dihedral(result.plan.level(k), result.points(k)));
    return found;
  };
  const auto check = [](const std::vector<double>& found, const std::vector<double>& expected) {
    for (std::size_t i = 0; i < 5; ++i) CHECK(found[i] == Approx(expected[i]).margin(0.005001));
  };
  check(angles(bolt_loop(), Preset::Refined), {75.96, 53.13, 29.74, 14.93, 7.62});
  check(angles(bolt_loop(), Preset::Paper), {75.96, 53.13, 29.74, 14.93, 8.53});
  check(angles(cube_top_loop(), Preset::Refined), {63.43, 36.70, 21.87, 12.68, 7.02});
  check(angles(cube_top_loop(), Preset::Paper), {45.0, 31.94, 21.9, 14.88, 10.05});
  check(angles(bolt_open_chain(), Preset::Refined), {75.96, 53.13, 31.89, 24.21, 17.66});
  check(angles(bolt_open_chain(), Preset::Paper), {75.96, 72.44, 73.31, 73.92, 74.95});
}

}  // namespace
}  // namespace croquis::test
