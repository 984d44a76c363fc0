// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "algorithms/silhouette/surface/mid_surface.h"
#include "algorithms/silhouette/surface/thickness.h"
#include "silhouette/figure_fixtures.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

/// A figure sampled, with its nodes at the heights given by their layer.
struct Stage {
  Skeleton skeleton;
  SheetSampling sheets;
  SheetOperator op;
  MidSurfaceData data;

  Stage(const test::FigureFixture& fixture, double height_per_layer) {
    Progress progress;
    skeleton = test::skeleton_of(fixture.figure);
    sheets = sample_sheets(fixture.figure, skeleton, progress);
    op = make_sheet_operator(sheets);
    data.nodes = locate_nodes(fixture.figure, skeleton, sheets);
    const auto count = static_cast<Eigen::Index>(data.nodes.size());
    data.node_z.resize(count);
    for (Eigen::Index n = 0; n < count; ++n) {
      data.node_z[n] = height_per_layer * skeleton.nodes[static_cast<std::size_t>(n)].place.layer;
    }
    data.node_length = Eigen::VectorXd::Constant(count, 0.3 * skeleton.scale);
    data.pairs = stacked_pairs(sheets);
    data.scale = skeleton.scale;
    data.gap = 0.1 * skeleton.scale;
  }
};

double least_clearance(const Stage& stage, const Eigen::VectorXd& z, const Eigen::VectorXd& thickness) {
  double least = 1e300;
  for (const StackedPair& pair : stage.data.pairs) {
    least = std::min(least, z[pair.upper] - z[pair.lower] - thickness[pair.upper] - thickness[pair.lower]);
  }
  return least;
}

}  // namespace

TEST_CASE("pairs are the sheets in front of each other at every point") {
  const Stage stage(test::trefoil_figure(), 0);
  REQUIRE(!stage.data.pairs.empty());
  for (const StackedPair& pair : stage.data.pairs) {
    CHECK(pair.upper != pair.lower);
    CHECK(stage.sheets.lifted.planar_vertex[pair.upper] == stage.sheets.lifted.planar_vertex[pair.lower]);
  }
  CHECK(Stage(test::ring_figure(), 0).data.pairs.empty());
}

TEST_CASE("nodes of one height make a flat sheet of that height") {
  Stage stage(test::snake_figure(), 0);
  stage.data.node_z.setConstant(17);
  stage.data.pairs.clear();
  MidSurface surface(stage.op, stage.data);
  Progress progress;
  const MidSurfaceResult result = surface.solve(Eigen::VectorXd::Zero(stage.op.stiffness.cols()), progress);
  CHECK((result.z.array() - 17).abs().maxCoeff() < 1e-6);
  CHECK(result.iterations == 0);
}

TEST_CASE("sheets that would touch are pushed apart to the gap and no further than needed") {
  const Stage stage(test::crossed_capsules_figure(), 0);
  const Eigen::Index count = stage.op.stiffness.cols();
  MidSurface surface(stage.op, stage.data);
  Progress progress;
  for (const double thickness : {0.0, 12.0, 30.0}) {
    const Eigen::VectorXd h = Eigen::VectorXd::Constant(count, thickness);
    const MidSurfaceResult result = surface.solve(h, progress);
    const double least = least_clearance(stage, result.z, h);
    CHECK(least >= stage.data.gap);
    CHECK(least <= stage.data.gap + 1e-3 * stage.data.scale);
  }
}

TEST_CASE("sheets far enough apart are left as they are") {
  const Stage stage(test::crossed_capsules_figure(), -200);
  MidSurface surface(stage.op, stage.data);
  Progress progress;
  const Eigen::VectorXd h = Eigen::VectorXd::Constant(stage.op.stiffness.cols(), 10);
  const MidSurfaceResult result = surface.solve(h, progress);
  CHECK(result.iterations == 0);
  CHECK(least_clearance(stage, result.z, h) > stage.data.gap);
}

TEST_CASE("triangles without area have a stiffness that can be reckoned with") {
  SheetSampling sheets;
  sheets.points = {{0, 0}, {1, 0}, {0.5, 1e-13}, {0.5, 1}};
  sheets.lifted.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}};
  sheets.lifted.neighbours = {{2, 1, no_index}, {2, no_index, 0}, {no_index, 1, 0}};
  sheets.lifted.planar_vertex = {0, 1, 2, 3};
  sheets.lifted.on_boundary = {1, 1, 0, 1};
  const SheetOperator op = make_sheet_operator(sheets);
  CHECK(op.stiffness.coeffs().cwiseAbs().maxCoeff() < 1e5);
  CHECK((op.stiffness * Eigen::VectorXd::Ones(4)).norm() < 1e-9);
  // What has area is what it is in the plane: the linear function x costs its gradient's square, half over this area.
  const Eigen::VectorXd x = Eigen::Vector4d(0, 1, 0.5, 0.5);
  CHECK(x.dot(op.stiffness * x) == Approx(0.5).epsilon(1e-6));
}
