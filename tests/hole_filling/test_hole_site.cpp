// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "croquis/hole_filling/hole_site.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

double greatest_tilt(const std::vector<ReachedVertex>& reached, const PolyMesh& mesh) {
  double tilt = 0;
  for (const ReachedVertex& r : reached) {
    if (r.distance == 0)
      tilt = std::max(tilt, std::acos(std::min(1.0, r.normal.dot(mesh.positions[r.vertex].normalized()))));
  }
  return tilt;
}

}  // namespace

TEST_CASE("vertices around a hole are reached along edges, nearest first") {
  const SiteScene scene(cut(sheet(20, 20), Vec3(10, 10, 0), 3).mesh);
  const auto reached = reach_from_rims(scene.site, 4);
  CHECK(std::is_sorted(reached.begin(), reached.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; }));
  std::set<Index> seen;
  std::size_t on_rim = 0;
  for (const ReachedVertex& r : reached) {
    CHECK(seen.insert(r.vertex).second);
    CHECK(r.distance <= 4);
    CHECK((r.normal - Vec3(0, 0, 1)).norm() < 1e-12);
    double nearest = 1e9;
    for (const Vec3& rim : scene.site.polygon.points)
      nearest = std::min(nearest, (rim - scene.mesh.positions[r.vertex]).norm());
    CHECK(nearest <= r.distance + 1e-12);
    on_rim += r.distance == 0;
  }
  CHECK(on_rim == scene.site.vertices.size());
}

TEST_CASE("normals of rims are those of the surface, once quadrics are fitted") {
  const SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.5).mesh);
  auto reached = reach_from_rims(scene.site, 0.5);
  const double before = greatest_tilt(reached, scene.mesh);
  fit_rim_normals(reached, scene.mesh.positions, tree_of(reached, scene.mesh.positions));
  CHECK(before > 0.015);
  CHECK(greatest_tilt(reached, scene.mesh) < before / 10);
}

TEST_CASE("normals at a sharp edge aren't turned far") {
  const SiteScene scene(cut(divided_box(12), Vec3(1, 0.5, 1), 0.2).mesh);
  auto reached = reach_from_rims(scene.site, 0.5);
  const auto before = reached;
  fit_rim_normals(reached, scene.mesh.positions, tree_of(reached, scene.mesh.positions));
  for (std::size_t i = 0; i < reached.size(); ++i) CHECK(reached[i].normal.dot(before[i].normal) > 0.86);
}

TEST_CASE("a surface's roughness is the noise that it was given, × an edge") {
  const PolyMesh ball = cut(round_sphere(5), Vec3(0, 0, 1), 0.3).mesh;
  const auto roughness = [](const PolyMesh& mesh, double reach) {
    const SiteScene scene(mesh);
    const auto reached = reach_from_rims(scene.site, reach);
    return surface_roughness(reached, scene.mesh.positions, tree_of(reached, scene.mesh.positions));
  };
  CHECK(roughness(ball, 0.6) < 0.005);
  for (const double noise : {0.02, 0.1, 0.2})
    CHECK(roughness(with_noise(ball, 3, noise), 0.6) == Approx(noise).epsilon(0.2));
  PolyMesh scaled = with_noise(ball, 3, 0.1);
  for (Vec3& p : scaled.positions) p = 1000 * p + Vec3(5, 0, 0);
  CHECK(roughness(scaled, 600) == Approx(0.1).epsilon(0.2));
}

TEST_CASE("sheets that pass by a hole are found where they are near, sparsely") {
  const PolyMesh holed = cut(sheet(20, 20), Vec3(10, 10, 0), 3).mesh;
  const SiteScene scene(merged(holed, translated(sheet(20, 20), Vec3(0, 0, 2))));
  const auto reached = reach_from_rims(scene.site, 3);
  const auto points = other_sheets(scene.site, reached, 3, 1, 40);
  CHECK_FALSE(points.empty());
  CHECK(points.size() <= 40);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(points[i].position.z() == 2);
    CHECK((points[i].normal - Vec3(0, 0, 1)).norm() < 1e-12);
    for (std::size_t j = 0; j < i; ++j) CHECK((points[i].position - points[j].position).norm() >= 1);
  }
  CHECK(other_sheets(scene.site, reached, 1.5, 1, 40).empty());
}

TEST_CASE("measures of a site are those of all its rims together") {
  const PolyMesh mesh = cut_ring(round_sphere(4), Vec3(0, 0, 1), 0.12, 0.4).mesh;
  const HoleAnalysis analysis = analysis_of(mesh);
  REQUIRE(analysis.holes.size() == 2);
  const HoleSite site = make_site(mesh, analysis, std::vector<Index>{0, 1}, {});
  double length = 0, widest = 0;
  std::size_t edges = 0;
  for (const Hole& hole : analysis.holes) {
    for (std::size_t i = 0; i < hole.vertices.size(); ++i, ++edges)
      length +=
          (mesh.positions[hole.vertices[(i + 1) % hole.vertices.size()]] - mesh.positions[hole.vertices[i]]).norm();
    for (const Index a : hole.vertices)
      for (const Index b : hole.vertices) widest = std::max(widest, (mesh.positions[a] - mesh.positions[b]).norm());
  }
  CHECK(rim_length(site) == Approx(length));
  CHECK(mean_rim_edge(site) == Approx(length / static_cast<double>(edges)));
  CHECK(widest_diameter(site) == Approx(widest));
}
