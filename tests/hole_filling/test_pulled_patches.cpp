// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/site_scene.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

FillResult fill(const PolyMesh& mesh, FillOptions options = {}) {
  Progress progress;
  if (options.requests.empty()) options.selection = Selection::All;
  options.flat_caps = false;
  return fill_holes(mesh, options, progress);
}

HoleRequest request_through(Index hole, std::vector<Vec3> places) {
  HoleRequest request;
  request.holes = {hole};
  request.through = std::move(places);
  return request;
}

std::vector<std::array<Vec3, 3>> new_triangles(const FillResult& result) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::size_t f = result.mesh.face_count() - result.new_faces; f < result.mesh.face_count(); ++f) {
    const auto c = result.mesh.face(f);
    triangles.push_back({result.mesh.positions[c[0]], result.mesh.positions[c[1]], result.mesh.positions[c[2]]});
  }
  return triangles;
}

/// The highest or lowest point of patches in a sheet at z = 0, whichever is farther.
double height(const FillResult& result) {
  double farthest = 0;
  for (const Vec3& p : new_points(result)) {
    if (std::abs(p.z()) > std::abs(farthest)) farthest = p.z();
  }
  return farthest;
}

PolyMesh holed_sheet() { return cut(sheet(30, 30), Vec3(15, 15, 0), 6.2).mesh; }

FillOptions inner(Fairness fairness, double bulge) {
  FillOptions options;
  options.fairness = fairness;
  options.bulge = bulge;
  return options;
}

FillResult fill_inner(const PolyMesh& mesh, const FillOptions& options) {
  Progress progress;
  return fill_holes(mesh, options, progress);
}

std::size_t self_intersections(const PolyMesh& mesh) {
  Progress progress;
  return *inspect(mesh, true, progress).self_intersections;
}

}  // namespace

TEST_CASE("a bulge lifts the patch steadily to the side that the faces look to") {
  const PolyMesh mesh = holed_sheet();
  for (const Fairness fairness : {Fairness::Implicit, Fairness::Tangent}) {
    double before = -std::numeric_limits<double>::infinity();
    for (const double bulge : {-1.0, -0.5, -0.2, 0.0, 0.2, 0.5, 1.0}) {
      const FillResult result = fill_inner(mesh, inner(fairness, bulge));
      const double now = height(result);
      INFO(static_cast<int>(fairness) << " " << bulge << ": " << now);
      CHECK(now > before + 0.1);
      before = now;
      CHECK(self_intersections(result.mesh) == 0);
    }
    CHECK(before > (fairness == Fairness::Implicit ? 1.5 : 0.8));  // a dome that leaves at 45 degrees is 2.5 high
    CHECK(before < 4);
  }
}

TEST_CASE("bulging outwards and inwards are each other's mirror images on a plane") {
  const PolyMesh mesh = holed_sheet();
  const double out = height(fill_inner(mesh, inner(Fairness::Implicit, 0.6)));
  const double in = height(fill_inner(mesh, inner(Fairness::Implicit, -0.6)));
  CHECK(out > 0);
  CHECK(std::abs(out + in) < 0.05 * out);
}

TEST_CASE("no bulge is the patch that there was, bit by bit") {
  const PolyMesh mesh = random_cuts(round_sphere(4), 4, 4, 0.15, 0.4).mesh;
  for (const Fairness fairness : {Fairness::Implicit, Fairness::Tangent}) {
    FillOptions options;
    options.fairness = fairness;
    const FillResult plain = fill_inner(mesh, options);
    options.bulge = 0;
    CHECK(fill_inner(mesh, options).mesh.positions == plain.mesh.positions);
  }
}

TEST_CASE("a patch goes through the places asked for, whatever the fairness") {
  const PolyMesh mesh = holed_sheet();
  const Index hole = inner_hole(mesh);
  const std::vector<std::vector<Vec3>> all_places = {{Vec3(15, 15, 2)},
                                                     {Vec3(15, 15, -4)},
                                                     {Vec3(13, 16, 0.5)},
                                                     {Vec3(12, 15, 1.5), Vec3(18, 15, -1.5)},
                                                     {Vec3(15, 15, 6)}};
  for (const Fairness fairness : {Fairness::Implicit, Fairness::Tangent, Fairness::Flat}) {
    for (const auto& places : all_places) {
      FillOptions options;
      options.fairness = fairness;
      options.requests = {request_through(hole, places)};
      const FillResult result = fill_inner(mesh, options);
      INFO(static_cast<int>(fairness) << " " << places.front().transpose());
      CHECK(result.outcomes[hole].method.find("implicit") == 0);
      const TriangleTree triangles(new_triangles(result));
      for (const Vec3& place : places) CHECK(triangles.nearest(place, 1).distance < 0.05);
      CHECK(self_intersections(result.mesh) == 0);
    }
  }
}

TEST_CASE("through a place of the sphere that was cut the cap stays round") {
  const PolyMesh mesh = cut(round_sphere(4), Vec3(0, 0, 1), 0.6).mesh;
  FillOptions options;
  options.requests = {request_through(0, {Vec3(0, 0, 1)})};
  for (const Vec3& p : new_points(fill(mesh, options))) CHECK(std::abs(p.norm() - 1) < 0.01);
}

TEST_CASE("a patch is pulled out smoothly: no spike at the place that it goes through") {
  const PolyMesh mesh = holed_sheet();
  FillOptions options;
  options.requests = {request_through(inner_hole(mesh), {Vec3(15, 15, 3)})};
  const FillResult result = fill_inner(mesh, options);
  double highest = 0, near_by = 0;
  for (const Vec3& p : new_points(result)) {
    highest = std::max(highest, p.z());
    if ((p - Vec3(15, 15, p.z())).norm() < 1.6) near_by = near_by == 0 ? p.z() : std::min(near_by, p.z());
  }
  CHECK(highest < 3.2);
  CHECK(near_by > 1.7);  // within an edge and a half of the top; a clamped plate has 2.2, a spike 1.4
}
