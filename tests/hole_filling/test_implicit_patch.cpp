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
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

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
