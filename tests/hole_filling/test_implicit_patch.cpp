// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

FillOptions everything() {
  FillOptions options;
  options.selection = Selection::All;
  options.flat_caps = false;
  return options;
}

/// Filled by one of the ways that continue the surface implicitly.
std::size_t count_of(const FillResult& result, const std::string& method) {
  return static_cast<std::size_t>(
      std::count_if(result.outcomes.begin(), result.outcomes.end(),
                    [&](const HoleOutcome& outcome) { return outcome.method.starts_with(method); }));
}

bool warns(const FillResult& result, const std::string& code) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const Finding& finding) { return finding.code == code; });
}

std::vector<Vec3> new_points(const FillResult& result) {
  return {result.mesh.positions.end() - static_cast<std::ptrdiff_t>(result.new_vertices), result.mesh.positions.end()};
}

struct Errors {
  double worst = 0, mean = 0;
};

/// Of the radius of the unit sphere, over new vertices and middles of new faces.
Errors radial_errors(const FillResult& result) {
  std::vector<double> errors;
  for (const Vec3& p : new_points(result)) errors.push_back(std::abs(p.norm() - 1));
  Errors of;
  for (const double error : errors) {
    of.worst = std::max(of.worst, error);
    of.mean += error / static_cast<double>(errors.size());
  }
  return of;
}

struct Shape {
  double mean_edge = 0;     // of the patch's inner edges
  double median_angle = 0;  // degrees, the smallest of each triangle
  double share_below_10 = 0;
};

Shape shape_of(const FillResult& result) {
  Shape shape;
  std::vector<double> angles;
  double edges = 0, count = 0;
  for (std::size_t f = result.mesh.face_count() - result.new_faces; f < result.mesh.face_count(); ++f) {
    const auto face = result.mesh.face(f);
    double least = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 out = result.mesh.positions[face[(i + 1) % 3]] - result.mesh.positions[face[i]];
      const Vec3 in = result.mesh.positions[face[(i + 2) % 3]] - result.mesh.positions[face[i]];
      least = std::min(least, std::atan2(out.cross(in).norm(), out.dot(in)) * 180 / std::numbers::pi);
      edges += out.norm();
      count += 1;
    }
    angles.push_back(least);
  }
  std::sort(angles.begin(), angles.end());
  shape.mean_edge = edges / count;
  shape.median_angle = angles[angles.size() / 2];
  shape.share_below_10 = static_cast<double>(std::lower_bound(angles.begin(), angles.end(), 10.0) - angles.begin()) /
                         static_cast<double>(angles.size());
  return shape;
}

double mean_rim_edge(const FillResult& result) {
  double perimeter = 0, count = 0;
  for (const Hole& hole : result.analysis.holes) {
    if (result.outcomes[hole.id].action != FillAction::Fill) continue;
    perimeter += hole.perimeter;
    count += static_cast<double>(hole.vertices.size());
  }
  return perimeter / count;
}

}  // namespace

TEST_CASE("a hole in a plane is continued in that plane") {
  const PolyMesh mesh = random_cuts(sheet(30, 30), 3, 3, 2, 5).mesh;
  const FillResult result = fill(mesh);
  CHECK(count_of(result, "implicit") == 3);
  for (const Vec3& p : new_points(result)) CHECK(std::abs(p.z()) < 1e-9 * 30 * std::sqrt(2.0));
}

TEST_CASE("the cap of a sphere is continued as a sphere") {
  for (const int levels : {4, 5}) {
    const FillResult result = fill(cut(round_sphere(levels), Vec3(0, 0, 1), 0.52).mesh);  // 30 degrees
    REQUIRE(count_of(result, "implicit") == 1);
    const Errors errors = radial_errors(result);
    INFO(levels);
    CHECK(errors.worst < 0.002);
    CHECK(errors.mean < 0.001);
    CHECK(result.outcomes[0].confidence > 0.6);
    CHECK(result.outcomes[0].confidence < 0.9);
    CHECK_FALSE(warns(result, "W_LOW_CONFIDENCE"));
  }
}

TEST_CASE("halving the edges brings the first ring much nearer to the surface") {
  const auto first_ring_error = [](int levels) {
    return mean_error_of_first_ring(fill(cut(round_sphere(levels), Vec3(0, 0, 1), 0.52).mesh));
  };
  const double coarse = first_ring_error(3), middle = first_ring_error(4), fine = first_ring_error(5);
  CAPTURE(coarse, middle, fine);
  CHECK(coarse > 2.5 * middle);
  CHECK(middle > 1.5 * fine);  // the limit on centres begins to tell
  CHECK(middle < 2e-5);
}

TEST_CASE("triangles of a patch are as large as the rim's edges and well shaped") {
  const std::vector<PolyMesh> shapes = {round_sphere(5), ring_torus(120, 60), uv_sphere(80, 60)};
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(3, 30)); ++seed) {
    for (const PolyMesh& shape : shapes) {
      const FillResult result = fill(random_cuts(shape, seed, 2, 0.2, 0.35).mesh);
      const Shape patch = shape_of(result);
      CAPTURE(seed, shape.vertex_count(), result.new_faces);
      CHECK(patch.mean_edge > 0.7 * mean_rim_edge(result));
      CHECK(patch.mean_edge < 1.4 * mean_rim_edge(result));
      CHECK(patch.median_angle >= 35);
      CHECK(patch.share_below_10 < 0.01);
    }
  }
}

TEST_CASE("a patch turns with the surface across its rim") {
  const PolyMesh mesh = cut(round_sphere(5), Vec3(0, 0, 1), 0.52).mesh;
  CHECK(fill(mesh).outcomes[0].max_normal_jump < 10 * std::numbers::pi / 180);
}

TEST_CASE("scaling and moving the mesh does the same to its patches") {
  const PolyMesh mesh = cut(ring_torus(60, 30), Vec3(1, 0, 0.3), 0.3).mesh;
  const FillResult plain = fill(mesh);
  const FillResult larger = fill(scaled(mesh, 1024));
  REQUIRE(larger.new_vertices == plain.new_vertices);
  for (std::size_t i = 0; i < plain.mesh.positions.size(); ++i)
    CHECK((larger.mesh.positions[i] / 1024 - plain.mesh.positions[i]).norm() < 1e-6 * 3);
}

TEST_CASE("an island and the hole around it become one surface that follows both") {
  const FillResult result = fill(cut_ring(round_sphere(5), Vec3(0, 0.6, 0.8), 0.25, 0.6).mesh);
  CHECK(count_of(result, "implicit") == 2);
  const MeshReport after = report_of(result.mesh);
  CHECK(after.components == 1);
  CHECK(after.closed);
  CHECK(after.genus == 0);
  CHECK(*after.self_intersections == 0);
  CHECK(radial_errors(result).worst < 0.003);
  CHECK(result.outcomes[0].confidence > 0.9);
}

TEST_CASE("huge holes are continued better than by fairing") {
  const PolyMesh mesh = cut(round_sphere(4), Vec3(0, 0, 1), 0.9).mesh;
  FillOptions options;
  Progress progress;
  options.fairness = Fairness::Tangent;
  options.only = {0};
  const Errors faired = radial_errors(fill_holes(mesh, options, progress));
  options.fairness = Fairness::Implicit;
  const FillResult result = fill(mesh, options);
  CHECK(count_of(result, "implicit") == 1);
  CHECK(radial_errors(result).mean < 0.6 * faired.mean);
}

TEST_CASE("borders of sheets and saddles that are to be closed come to an end") {
  PolyMesh saddle = sheet(20, 20);
  for (Vec3& p : saddle.positions) p.z() = 0.02 * (p.x() - 10) * (p.y() - 10);
  for (const PolyMesh& mesh : {sheet(20, 20), saddle}) {
    const FillResult result = fill(mesh, everything());
    REQUIRE(result.outcomes.size() == 1);
    if (result.outcomes[0].action == FillAction::Fill)
      CHECK(*report_of(result.mesh).self_intersections == 0);
    else
      CHECK_FALSE(result.outcomes[0].reason.empty());
  }
}

TEST_CASE("holes through both skins of a thin shell are closed one by one") {
  for (const double wall : {0.03, 0.06, 0.1}) {
    const PolyMesh whole = shell(4, wall);
    const PolyMesh mesh = cut(cut(whole, Vec3(0, 0, 1), 0.3).mesh, Vec3(0, 0, 1 - wall), 0.3).mesh;
    const FillResult result = fill(mesh);
    const MeshReport after = report_of(result.mesh);
    INFO(wall);
    CHECK(after.components == 2);
    CHECK(after.closed);
    CHECK(*after.self_intersections == 0);
    CHECK(after.nonmanifold_edges == 0);
  }
}

TEST_CASE("ends of a tube get flat caps unless these are declined") {
  FillOptions options = everything();
  options.flat_caps = true;
  const PolyMesh mesh = open_tube(1, 4, 32, 10);
  CHECK(fill(mesh, options).new_vertices == 0);
  const FillResult round = fill(mesh, everything());
  CHECK(report_of(round.mesh).closed);
  CHECK(*report_of(round.mesh).self_intersections == 0);
  double highest = 0;
  for (const Vec3& p : round.mesh.positions) highest = std::max(highest, std::abs(p.z() - 2));
  CHECK(highest < 2 + 2);  // no farther than the tube is wide
  CHECK(warns(round, "W_LOW_CONFIDENCE"));
}

TEST_CASE("half a sphere is closed with little confidence") {
  const FillResult result = fill(bowl(60, 16), everything());
  REQUIRE(result.outcomes[0].action == FillAction::Fill);
  CHECK(result.outcomes[0].confidence < 0.3);
  CHECK(warns(result, "W_LOW_CONFIDENCE"));
}

TEST_CASE("every kernel continues a sphere") {
  const PolyMesh mesh = cut(round_sphere(5), Vec3(0, 0, 1), 0.4).mesh;
  for (const implicit::Kernel kernel : {implicit::Kernel::Hermite, implicit::Kernel::Triharmonic,
                                        implicit::Kernel::Biharmonic, implicit::Kernel::ThinPlate}) {
    FillOptions options;
    options.implicit.kernel = kernel;
    const FillResult result = fill(mesh, options);
    CHECK(count_of(result, "implicit") == 1);
    CHECK(radial_errors(result).mean < 0.01);
  }
}

TEST_CASE("smoothing follows a rough surface's noise without being asked to") {
  const PolyMesh mesh = with_noise(cut(round_sphere(5), Vec3(0, 0, 1), 0.4).mesh, 7, 0.1);
  FillOptions little = everything();
  little.implicit.value_smoothing *= 1e-6;
  little.implicit.gradient_smoothing *= 1e-6;
  CHECK(radial_errors(fill(mesh, everything())).mean < 0.6 * radial_errors(fill(mesh, little)).mean);
}

TEST_CASE("the same hole gets the same patch every time, and a filled mesh stays as it is") {
  const PolyMesh mesh = random_cuts(ring_torus(60, 30), 4, 4, 0.15, 0.3).mesh;
  const FillResult once = fill(mesh), twice = fill(mesh);
  CHECK(once.mesh.positions == twice.mesh.positions);
  CHECK(once.mesh.corners == twice.mesh.corners);
  CHECK(fill(once.mesh).mesh.corners == once.mesh.corners);
}

TEST_CASE("a long rim leaves room for centres behind it") {
  const auto error = [](int levels) {
    return radial_errors(fill(cut(round_sphere(levels), Vec3(0, 0, 1), 0.9).mesh)).mean;
  };
  CHECK(error(6) < 0.005);  // 300 rim edges, more than there may be centres
}

TEST_CASE("a patch never has more triangles than allowed by far") {
  FillOptions options;
  options.most_patch_triangles = 500;
  const FillResult result = fill(cut(round_sphere(5), Vec3(0, 0, 1), 0.8).mesh, options);
  CHECK(count_of(result, "implicit") == 1);
  CHECK(result.new_faces < 1000);
  CHECK(radial_errors(result).worst < 0.02);
}

TEST_CASE("rims of thousands of edges are continued too") {
  std::vector<Vec2> profile = {{0, -1}};
  for (int i = 1; i <= 40; ++i) {  // two thirds of the way from pole to pole
    const double angle = std::numbers::pi * 2 / 3 * i / 40;
    profile.emplace_back(std::sin(angle), -std::cos(angle));
  }
  const FillResult result = fill(revolved(profile, 3000), everything());
  CHECK(count_of(result, "implicit") == 1);
  CHECK(report_of(result.mesh).closed);
  CHECK(result.new_faces < 2 * 40000);
}
