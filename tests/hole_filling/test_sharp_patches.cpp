// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/continuation/creases.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/surface_distance.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// Outside the unit box, negative inside.
double box_value(const Vec3& p) { return std::max({(p - Vec3::Ones()).maxCoeff(), (-p).maxCoeff()}); }

FillResult fill(const PolyMesh& mesh, Preset preset) {
  FillOptions options;
  options.preset = preset;
  options.selection = Selection::All;
  options.flat_caps = false;
  Progress progress;
  return fill_holes(mesh, options, progress);
}

/// Mean distance of new vertices and middles of new edges to a surface.
template <typename Value>
double mean_error(const FillResult& result, Value value) {
  double sum = 0, count = 0;
  for (std::size_t f = result.mesh.face_count() - result.new_faces; f < result.mesh.face_count(); ++f) {
    const auto c = result.mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      sum += std::abs(value(0.5 * (result.mesh.positions[c[i]] + result.mesh.positions[c[(i + 1) % 3]])));
      count += 1;
    }
  }
  return sum / count;
}

}  // namespace

TEST_CASE("the sides of a box around a hole are distinguished by its edges") {
  const std::vector<std::pair<Vec3, std::size_t>> expected = {
      {Vec3(0.5, 0.5, 1), 1}, {Vec3(0.5, 1, 1), 2}, {Vec3(1, 1, 1), 3}};
  for (const auto& [centre, count] : expected) {
    const SiteScene scene(cut(divided_box(16), centre, 0.22).mesh);
    const auto sides = smooth_sides(known_surface(scene.site, 0.6, 6, 4000));
    INFO(centre.transpose());
    CHECK(sides.size() == count);
    for (const SmoothSide& side : sides) {
      for (const Vec3& normal : side.normals) CHECK((normal - side.normals.front()).norm() < 1e-9);
    }
  }
}

TEST_CASE("a smooth surface is one side") {
  const SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.4).mesh);
  const KnownSurface known = known_surface(scene.site, 0.6, 6, 4000);
  const auto sides = smooth_sides(known);
  REQUIRE(sides.size() == 1);
  CHECK(sides.front().vertices.size() == known.mesh.vertex_count());
}

TEST_CASE("fits of a box' sides combine to the box around its edges and corners") {
  for (const Vec3& centre : {Vec3(0.5, 1, 1), Vec3(1, 1, 1)}) {
    const SiteScene scene(cut(divided_box(16), centre, 0.22).mesh);
    const auto field = fit_sides(scene.site, usual_side_residual);
    REQUIRE(field);
    for (const Vec3& offset : {Vec3(0.01, 0.02, 0.03), Vec3(-0.1, -0.02, 0.04), Vec3(-0.05, -0.07, -0.01)}) {
      const Vec3 place = centre + offset;
      CHECK(field->value(place).value == Approx(box_value(place)).margin(1e-6));
    }
  }
}

TEST_CASE("preset sharp continues edges and corners of a box: errors a tenth of the standard's") {
  for (const Vec3& centre : {Vec3(0.5, 1, 1), Vec3(1, 1, 1), Vec3(0.3, 0, 1)}) {
    const PolyMesh mesh = cut(divided_box(20), centre, 0.23).mesh;
    const FillResult sharp = fill(mesh, Preset::Sharp);
    const double standard = mean_error(fill(mesh, Preset::Standard), box_value);
    INFO(centre.transpose() << " " << sharp.outcomes[0].method << " " << sharp.outcomes[0].reason);
    CHECK(sharp.outcomes[0].method == "creased");
    CHECK(mean_error(sharp, box_value) < 0.2 * standard);
    CHECK(sharp.outcomes[0].expected_error < 0.01);
    Progress progress;
    CHECK(*inspect(sharp.mesh, true, progress).self_intersections == 0);
  }
}

TEST_CASE("creases that run into a hole go on in it without being asked for; nothing changes where there are none") {
  for (const Vec3& centre : {Vec3(0.5, 1, 1), Vec3(1, 1, 1)}) {
    const PolyMesh mesh = cut(divided_box(20), centre, 0.16).mesh;
    const FillResult result = fill(mesh, Preset::Auto);
    CHECK(result.outcomes[0].method == "creased");
    CHECK(result.outcomes[0].reason.empty());
    CHECK(mean_error(result, box_value) < 0.4 * mean_error(fill(mesh, Preset::Standard), box_value));
  }
  for (const PolyMesh& mesh :
       {cut(round_sphere(4), Vec3(0, 0, 1), 0.5).mesh, cut_ring(round_sphere(5), Vec3(0, 0.6, 0.8), 0.25, 0.6).mesh,
        cut(divided_box(20), Vec3(0.5, 0.5, 1), 0.2).mesh}) {
    const FillResult result = fill(mesh, Preset::Auto), standard = fill(mesh, Preset::Standard);
    CHECK(result.mesh.positions == standard.mesh.positions);
    CHECK(result.mesh.corners == standard.mesh.corners);
  }
}

TEST_CASE("creases go on between a hole's rim and its island") {
  const PolyMesh mesh = cut_ring(divided_box(30), Vec3(0.5, 1, 1), 0.08, 0.24).mesh;
  const FillResult result = fill(mesh, Preset::Auto);
  REQUIRE(result.analysis.holes.size() == 2);
  for (const HoleOutcome& outcome : result.outcomes) CHECK(outcome.method == "creased");
  CHECK(mean_error(result, box_value) < 0.1 * mean_error(fill(mesh, Preset::Standard), box_value));
}

TEST_CASE("slight bevels of fine flat sides are creases, which go on in holes") {
  for (const double degrees : {15, 25}) {
    PolyMesh mesh = cut(divided_box(24), Vec3(0.5, 0.5, 1), 0.2).mesh;
    const double slope = std::tan(degrees * std::numbers::pi / 180);
    const auto height = [&](const Vec3& p) { return 1 - slope * std::max(0.0, p.x() - 0.5); };
    for (Vec3& p : mesh.positions) p.z() *= height(p);
    const FillResult result = fill(mesh, Preset::Auto);
    INFO(degrees << " degrees");
    CHECK(result.outcomes[0].method == "creased");
    for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v)
      CHECK(std::abs(result.mesh.positions[v].z() - height(result.mesh.positions[v])) < 1e-4);
  }
}

TEST_CASE("without being asked for, creases go on only where the sides between them are smooth") {
  const PolyMesh mesh = with_noise(cut(divided_box(20), Vec3(0.5, 1, 1), 0.16).mesh, 7, 0.1);
  CHECK(fill(mesh, Preset::Auto).outcomes[0].method == "implicit");
}

TEST_CASE("what is usual on a rough or a round surface is no crease") {
  const SiteScene flat(cut(divided_box(16), Vec3(0.5, 0.5, 1), 0.22).mesh);
  const SiteScene coarse(cut(round_sphere(2), Vec3(0, 0, 1), 0.4).mesh);
  CHECK(crease_cosine(flat.site) == Approx(std::cos(12 * std::numbers::pi / 180)));
  CHECK(crease_cosine(coarse.site) == Approx(std::cos(35 * std::numbers::pi / 180)));
}

TEST_CASE("a hole beside an edge is filled flat: what lies beyond the edge doesn't bend it") {
  const PolyMesh mesh = cut(divided_box(20), Vec3(0.5, 0.8, 1), 0.16).mesh;
  const FillResult result = fill(mesh, Preset::Standard);
  for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v)
    CHECK(std::abs(result.mesh.positions[v].z() - 1) < 1e-9);
}

TEST_CASE("machined sculptures come out better by preset sharp, smooth ones not worse") {
  for (const Sculpture sculpture : {Sculpture::Bracket, Sculpture::Beast}) {
    const PolyMesh complete = sculpt(sculpture, 12000);
    RaggedCuts cuts;
    cuts.seed = 3;
    const CutScan scan = ragged_cuts(complete, cuts);
    const auto error = [&](Preset preset) {
      const FillResult result = fill(scan.mesh, preset);
      const SurfaceDistance distance(result.mesh, scan.mesh.face_count());
      double sum = 0;
      for (const auto& removed : scan.removed)
        sum += summary_of_distances(sample_faces(complete, removed, 200), distance).mean;
      return sum;
    };
    INFO(name_of(sculpture));
    CHECK(error(Preset::Sharp) < (is_machined(sculpture) ? 0.8 : 1.05) * error(Preset::Standard));
  }
}

TEST_CASE("the surface goes on over rough rims, too, and preset noisy makes calmer patches there than the standard") {
  // Mean distance of new vertices from the sphere.
  const auto roughness = [](const PolyMesh& mesh, Preset preset) {
    const FillResult result = fill(mesh, preset);
    CHECK(result.outcomes[0].method.starts_with("implicit"));
    double sum = 0;
    for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v)
      sum += std::abs(result.mesh.positions[v].norm() - 1);
    return sum / static_cast<double>(result.new_vertices);
  };
  const PolyMesh calm = cut(round_sphere(5), Vec3(0, 0, 1), 0.5).mesh;
  for (const double noise : {0.1, 0.25, 0.35}) {
    double noisy = 0, standard = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sample_count(6, 40)); ++seed) {
      const PolyMesh mesh = with_noise(calm, seed, noise);
      noisy += roughness(mesh, Preset::Noisy);
      standard += roughness(mesh, Preset::Standard);
    }
    INFO("noise of " << noise << " edges");
    CHECK(noisy < 0.95 * standard);
  }
}
