// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/solid_lines.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "silhouette/figure_fixtures.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

constexpr Index straight_nodes = 40;

/// Nodes a third of a radius apart.
Skeleton straight_skeleton(double slope) {
  Skeleton skeleton;
  for (Index n = 0; n < straight_nodes; ++n) {
    skeleton.nodes.emplace_back();
    skeleton.nodes.back().position = Vec2(10.0 * n, 0);
    skeleton.nodes.back().radius = 30;
    skeleton.nodes.back().z = slope * 10 * n;
    if (n > 0) skeleton.edges.push_back({n - 1, n});
  }
  return skeleton;
}

Eigen::VectorXd depths_of(const Skeleton& skeleton) {
  Eigen::VectorXd z(static_cast<Eigen::Index>(skeleton.nodes.size()));
  for (Eigen::Index n = 0; n < z.size(); ++n) z[n] = skeleton.nodes[static_cast<std::size_t>(n)].z;
  return z;
}

}  // namespace

TEST_CASE("a limb of slope s is thicker by the root of 1 + s squared, at most twice") {
  for (const double slope : {0.0, 0.5, -1.0, 5.0}) {
    const Skeleton skeleton = straight_skeleton(slope);
    const SweptLimbs limbs = swept_limbs(skeleton, depths_of(skeleton));
    const double wanted = std::min(2.0, std::sqrt(1 + slope * slope));
    for (Index n = 4; n + 4 < straight_nodes; ++n) CHECK(limbs.tilt[n] == Approx(wanted).epsilon(0.002));
    // Its ends are half balls, whose upper half is as high as a level one's.
    CHECK(limbs.tilt[0] == Approx(std::min(2.0, (1 + std::sqrt(1 + slope * slope)) / 2)).epsilon(0.002));
  }
}

TEST_CASE("a ball of its own is no thicker than its radius, and balls of other sheets don't count") {
  Skeleton skeleton;
  for (const double z : {0.0, 500.0}) {
    skeleton.nodes.emplace_back();
    skeleton.nodes.back().radius = 20;
    skeleton.nodes.back().z = z;
  }
  CHECK(swept_limbs(skeleton, depths_of(skeleton)).tilt == Eigen::VectorXd::Ones(2));
}

TEST_CASE("a bent limb is as high as the balls that its axis carries") {
  // Half a circle of radius 200, standing upright, seen from above: a torus of tube 30.
  Skeleton skeleton;
  for (Index n = 0; n <= 60; ++n) {
    skeleton.nodes.emplace_back();
    skeleton.nodes.back().position = Vec2(-180 + 6.0 * n, 0);
    skeleton.nodes.back().radius = 30;
    skeleton.nodes.back().z = std::sqrt(200.0 * 200 - std::pow(skeleton.nodes.back().position.x(), 2));
    if (n > 0) skeleton.edges.push_back({n - 1, n});
  }
  const SweptLimbs limbs = swept_limbs(skeleton, depths_of(skeleton));
  for (Index n = 12; n <= 48; ++n) {
    const double x = skeleton.nodes[n].position.x();
    const double top = std::sqrt(230.0 * 230 - x * x);
    const double bottom = std::sqrt(170.0 * 170 - x * x);
    CHECK(limbs.tilt[n] == Approx((top - bottom) / 60).epsilon(0.01));
    CHECK(limbs.lift[n] == Approx((top + bottom) / 2 - skeleton.nodes[n].z).margin(0.5));
  }
}

TEST_CASE("sheets keep their order and gap, and the proof of it notices when they don't") {
  for (const test::FigureFixture& fixture : {test::crossed_capsules_figure(), test::trefoil_figure()}) {
    InflatedSheets sheets = test::inflated_sheets(fixture.figure);
    for (const Rounding rounding : {Rounding::None, Rounding::Single, Rounding::Grid}) {
      CHECK(sheets_in_order(sheets, rounding, fixture.figure.unit));
    }
    const double gap = least_gap(sheets);
    CHECK(gap > 0);

    const StackedPair pair = sheets.pairs[sheets.pairs.size() / 2];
    const double height = sheets.z[pair.upper];
    sheets.z[pair.upper] = sheets.z[pair.lower];
    CHECK(!sheets_in_order(sheets, Rounding::None, fixture.figure.unit));
    CHECK(least_gap(sheets) < 0);
    sheets.z[pair.upper] = height;
    std::swap(sheets.sampling.points[sheets.sampling.planar.triangles[0][0]],
              sheets.sampling.points[sheets.sampling.planar.triangles[0][1]]);
    CHECK(!sheets_in_order(sheets, Rounding::None, fixture.figure.unit));
  }
}

TEST_CASE("each object's surface is apart from the others") {
  const test::FigureFixture fixture = test::linked_rings_figure();
  const InflatedSheets sheets = test::inflated_sheets(fixture.figure);
  const SheetMesh mesh = make_sheet_mesh(sheets, objects_of_triangles(fixture.figure, sheets.sampling));
  const std::vector<Shell> surfaces = object_surfaces(fixture.figure, mesh);
  REQUIRE(surfaces.size() == 2);
  for (const Shell& surface : surfaces) {
    CHECK(surface.euler == 0);
    CHECK(validate(surface.mesh).empty());
    std::vector<std::uint8_t> used(surface.mesh.vertex_count(), 0);
    for (const Index v : surface.mesh.corners) used[v] = 1;
    CHECK(std::count(used.begin(), used.end(), 0) == 0);
  }
}

TEST_CASE("the certificate names what is wrong with a mesh") {
  Progress progress;
  const PolyMesh sphere = test::triangulated(test::uv_sphere(16, 8));
  const PolyMesh torus = test::triangulated(test::torus(16, 8));
  const PolyMesh inside_out = test::flipped(sphere);
  const Index first[] = {0};
  const PolyMesh open = test::without_faces(sphere, first);
  CHECK(topology_fault(sphere, 1, progress).empty());
  CHECK(topology_fault(torus, 0, progress).empty());
  CHECK(topology_fault(torus, 1, progress).find("Euler") != std::string::npos);
  CHECK(topology_fault(inside_out, 1, progress).find("outwards") != std::string::npos);
  CHECK(topology_fault(open, 1, progress).find("closed") != std::string::npos);

  const PolyMesh near = test::translated(sphere, {0.5, 0.1, 0.2});
  const PolyMesh far = test::translated(sphere, {9, 0, 0});
  const std::vector<const PolyMesh*> meshes{&sphere, &far, &near};
  const auto meeting = meeting_faces(meshes, Rounding::None, 1, progress);
  CHECK(!meeting.empty());
  for (const auto& [first_face, second_face] : meeting) {
    CHECK(first_face.mesh == 0);
    CHECK(second_face.mesh == 2);
  }
}

TEST_CASE("the overlap of shifted squares is exact along the scan lines") {
  PolyMesh square;
  square.positions = {{0, 0, 3}, {2, 0, 3}, {2, 2, 3}, {0, 2, 3}};
  square.add_triangle(0, 1, 2);
  square.add_triangle(0, 2, 3);
  const std::vector<Vec2> shifted{{1, 0}, {3, 0}, {3, 2}, {1, 2}};
  const PolyMesh* mesh = &square;
  const Overlap overlap = silhouette_overlap({&mesh, 1}, {{shifted, 1}});
  CHECK(overlap.ratio() == Approx(1.0 / 3).epsilon(1e-3));
  CHECK(overlap.either == Approx(6).epsilon(2e-3));
  const std::vector<Vec2> backwards{{1, 2}, {3, 2}, {3, 0}, {1, 0}};
  CHECK(silhouette_overlap({&mesh, 1}, {{backwards, -1}}).ratio() == Approx(1.0 / 3).epsilon(1e-3));
  // A hole: the outline of a hole runs the other way round.
  const std::vector<Vec2> outer{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<Vec2> hole{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
  CHECK(silhouette_overlap({&mesh, 1}, {{outer, 1}, {hole, -1}}).ratio() == Approx(0.75).epsilon(1e-3));
  CHECK(silhouette_overlap({}, {}).ratio() == 1);
}

TEST_CASE("skeleton branches become one polyline each, loops close") {
  Skeleton skeleton;
  skeleton.nodes.resize(8);  // a Y of four nodes, a triangle, a lone node
  for (Index n = 0; n < 8; ++n) skeleton.nodes[n].radius = n + 1;
  skeleton.edges = {{0, 1}, {1, 2}, {1, 3}, {4, 5}, {5, 6}, {6, 4}};
  PolyMesh curves;
  append_skeleton(skeleton, curves);
  append_skeleton(skeleton, curves);
  CHECK(curves.vertex_count() == 16);
  REQUIRE(curves.line_count() == 8);
  int loops = 0;
  for (std::size_t l = 0; l < 8; ++l) {
    const auto line = curves.line(l);
    loops += line.front() == line.back() ? 1 : 0;
    CHECK(line.size() == (line.front() == line.back() ? 4U : 2U));
  }
  CHECK(loops == 2);
  CHECK(validate(curves).empty());
  const auto& radii = std::get<std::vector<double>>(curves.channel("radius", Domain::Vertex)->data);
  CHECK(radii[11] == 4);
}
