// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/fairing/even_refinement.h"
#include "algorithms/hole_filling/fairing/harmonic_values.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"
#include "hole_filling/site_scene.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// A regular polygon in the plane z = 0 as a fan, and nothing around it.
FairingInput disc(Index corners, double radius) {
  FairingInput input;
  for (Index i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    input.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (Index i = 1; i + 1 < corners; ++i) input.patch.push_back({0, i, i + 1});
  return input;
}

/// The disc's patch as one of a mesh that has the rim alone.
HolePatch as_patch(const FairingResult& refined) { return {{0}, refined.new_points, refined.patch}; }

struct DiscMeasures {
  double area = 0, mean_edge = 0;
  std::size_t boundary_edges = 0, nonmanifold_edges = 0;
};

DiscMeasures measure(const FairingInput& input, const FairingResult& refined) {
  std::vector<Vec3> points = input.points;
  points.insert(points.end(), refined.new_points.begin(), refined.new_points.end());
  DiscMeasures measures;
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : refined.patch) {
    measures.area += triangle_area(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  }
  for (const auto& [edge, count] : edges) {
    measures.mean_edge += (points[edge.first] - points[edge.second]).norm() / static_cast<double>(edges.size());
    measures.boundary_edges += count == 1;
    measures.nonmanifold_edges += count > 2;
  }
  return measures;
}

}  // namespace

TEST_CASE("refining keeps a patch's rim and its area, and gives the edges asked for") {
  for (const double coarseness : {1.0, 2.0}) {
    for (const Index corners : {12u, 60u, 240u}) {
      const FairingInput input = disc(corners, 1);
      const double edge = (input.points[0] - input.points[1]).norm();
      const auto refined = refine_evenly(input, coarseness);
      REQUIRE(refined);
      const DiscMeasures measures = measure(input, *refined);
      CHECK(measures.area == Approx(0.5 * corners * std::sin(2 * std::numbers::pi / corners)));
      CHECK(measures.boundary_edges == corners);
      CHECK(measures.nonmanifold_edges == 0);
      if (corners > 12) CHECK(measures.mean_edge / edge == Approx(coarseness).epsilon(0.3));
    }
  }
}

TEST_CASE("refining refuses triangles that are no surface") {
  FairingInput input = disc(12, 1);
  input.patch.push_back(input.patch.front());
  CHECK_FALSE(refine_evenly(input, 1));
}

TEST_CASE("harmonic values are the mean of their neighbours', and exact where the rim has one value") {
  const FairingInput input = disc(100, 3);
  const auto refined = refine_evenly(input, 1);
  REQUIRE(refined);
  const HolePatch patch = as_patch(*refined);
  const auto given = static_cast<Index>(input.points.size());
  const PatchGraph graph(patch, given);
  REQUIRE(graph.rim_vertices().size() == given);

  const std::vector<double> same(given, 0.1);
  for (const double value : graph.harmonic(same, 1e-9)) CHECK(value == 0.1);

  std::vector<double> heights;
  std::vector<Vec3> places;
  for (const Index v : graph.rim_vertices()) {
    heights.push_back(std::sin(5 * input.points[v].x()) + input.points[v].y());
    places.push_back({heights.back(), -heights.back(), 1});
  }
  const std::vector<double> found = graph.harmonic(heights, 1e-9);
  const std::vector<Vec3> moved = graph.harmonic(places, 1e-9);
  std::vector<double> all = heights, sums(given + found.size(), 0), counts(sums.size(), 0);
  all.insert(all.end(), found.begin(), found.end());
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sums[t[i]] += all[t[(i + 1) % 3]] + all[t[(i + 2) % 3]];
      counts[t[i]] += 2;
    }
  }
  for (std::size_t v = 0; v < found.size(); ++v) {
    CHECK(found[v] == Approx(sums[given + v] / counts[given + v]).margin(1e-7));
    CHECK((moved[v] - Vec3(found[v], -found[v], 1)).norm() < 1e-6);
  }
}

TEST_CASE("a site's memory changes no patch, and forgets what was made while other edges were free") {
  SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.4).mesh);
  Progress progress;
  const auto method = faired_patcher(1, 40000);
  const auto plain = method->attempt(scene.site, progress);
  SiteMemory memory;
  scene.site.memory = &memory;
  const auto first = method->attempt(scene.site, progress);
  REQUIRE(plain);
  REQUIRE(first);
  CHECK(first->points == plain->points);
  CHECK(first->triangles == plain->triangles);
  REQUIRE(memory.patches.size() == 1);
  memory.patches.begin()->second->points.pop_back();  // to be seen again
  CHECK(method->attempt(scene.site, progress)->points.size() + 1 == plain->points.size());
  CHECK(fitted_once(scene.site, {}, {})->fit == fitted_once(scene.site, {}, {})->fit);
  scene.site.polygon.blocked = {{0, 2}};
  CHECK(method->attempt(scene.site, progress)->points.size() == plain->points.size());
}

TEST_CASE("a patch to begin with lies between its rims' heights, whatever its size") {
  for (const double radius : {0.15, 0.4, 0.8}) {
    const SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), radius).mesh);
    Progress progress;
    const auto patch = evenly_faired_patcher(40000)->attempt(scene.site, progress);
    REQUIRE(patch);
    REQUIRE_FALSE(patch->points.empty());
    double lowest = 1;
    for (const Vec3& rim : scene.site.polygon.points) lowest = std::min(lowest, rim.z());
    for (const Vec3& point : patch->points) {
      CHECK(point.z() > lowest - 1e-9);
      CHECK(point.norm() < 1.1);
    }
  }
}

TEST_CASE("a few normals continue a sphere as well as all of them, with a third of the unknowns") {
  for (const double radius : {0.2, 0.35}) {
    const SiteScene scene(cut(round_sphere(5), Vec3(0, 0, 1), radius).mesh);
    REQUIRE(continues_curvature(scene.site, {}));
    const auto few = fit_rims(scene.site, {}, {});
    const auto all = fit_rims(scene.site, {}, {.every_normal = true});
    REQUIRE(few);
    REQUIRE(all);
    CHECK(all->fit->report().unknowns == 4 * all->fit->report().centres);
    CHECK(3 * few->fit->report().unknowns < 4 * few->fit->report().centres * 2);
    CHECK(few->fit->report().unknowns > few->fit->report().centres);
    for (const double angle : {0.0, 0.3, 0.6, 0.9}) {
      const double away = angle * radius;
      const Vec3 place(std::sin(away), 0, std::cos(away));
      CHECK(std::abs(few->fit->value(place)) < 2e-3 * radius);
      CHECK(few->fit->gradient(place).normalized().dot(place) > 0.9999);
    }
  }
}

TEST_CASE("wide holes, islands, bulges and pulled patches aren't continued with their curvature") {
  SiteScene wide(cut(round_sphere(4), Vec3(0, 0, 1), 1).mesh);
  CHECK_FALSE(continues_curvature(wide.site, {}));
  SiteScene small(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  CHECK(continues_curvature(small.site, {}));
  CHECK_FALSE(continues_curvature(small.site, {.kernel = implicit::Kernel::Triharmonic}));
  small.site.wish.bulge = 0.5;
  CHECK_FALSE(continues_curvature(small.site, {}));
}
