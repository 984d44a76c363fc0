// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "algorithms/hole_filling/verification/patch_verification.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::hole_filling;
using namespace croquis::test;

namespace {

Box box_around(const PolyMesh& mesh, const Hole& hole) {
  Box box;
  for (const Index vertex : hole.vertices) box.extend(mesh.positions[vertex]);
  return box;
}

/// Boxes looked at when each hole of a sheet with a hole in every third square asks what is near.
std::size_t boxes_looked_at(Index rows) {
  const PolyMesh whole = sheet(3 * rows, 3 * rows);
  std::vector<Index> removed;
  for (Index f = 0; f < whole.face_count(); ++f) {
    const Vec3& corner = whole.positions[whole.face(f)[0]];
    const Vec3 middle = (corner + whole.positions[whole.face(f)[1]] + whole.positions[whole.face(f)[2]]) / 3;
    if (static_cast<int>(middle.x()) % 3 == 1 && static_cast<int>(middle.y()) % 3 == 1) removed.push_back(f);
  }
  const PolyMesh mesh = shuffled(without_faces(whole, removed), 1);
  const HoleAnalysis analysis = analysis_of(mesh);
  REQUIRE(analysis.holes.size() == std::size_t{rows} * rows + 1);
  const SurfaceSearch search(mesh, analysis.view);
  for (const Hole& hole : analysis.holes) {
    if (hole.kind != HoleClass::Outer) CHECK(search.near(box_around(mesh, hole)).size() > 4);
  }
  return search.boxes_looked_at();
}

struct Site {
  PolyMesh mesh;
  HoleAnalysis analysis;
  HoleSite site;

  Site(PolyMesh given, Index hole) : mesh(std::move(given)), analysis(analysis_of(mesh)) {
    site = make_site(mesh, analysis, std::vector<Index>{hole}, {});
  }

  bool is_sound(const HolePatch& patch) const {
    Progress progress;
    PatchVerifier verifier(mesh, analysis);
    return verifier.accept_sound(std::vector{patch}, progress)[0].is_sound();
  }

  HolePatch patch_of(std::vector<std::array<Index, 3>> triangles) const {
    for (auto& t : triangles) {
      for (Index& vertex : t) vertex = site.vertices[vertex];
    }
    return {site.holes, {}, std::move(triangles)};
  }
};

/// Turns the edge from corner `side` of a triangle over within its two triangles, whatever that looks like.
bool flip(HolePatch& patch, std::size_t triangle, std::size_t side) {
  auto& t = patch.triangles[triangle];
  const Index a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
  for (auto& u : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (u[i] != b || u[(i + 1) % 3] != a) continue;
      const Index d = u[(i + 2) % 3];
      t = {a, d, c};
      u = {b, c, d};
      return true;
    }
  }
  return false;
}

/// A flat sheet with a hole like a cross, whose inner corners are reflex.
Site cross() { return Site(without_faces(grid(7, 7), std::vector<Index>{17, 23, 24, 25, 31}), 1); }

}  // namespace

TEST_CASE("triangles near boxes are those that a look at all finds, question after question") {
  for (const PolyMesh& mesh : {round_sphere(3), shuffled(round_sphere(4), 2), as_soup(ring_torus(20, 12)), sheet(1, 1),
                               translated(ring_torus(30, 20), Vec3(1e6, 0, 0))}) {
    const HoleAnalysis analysis = analysis_of(mesh);
    const SurfaceSearch search(mesh, analysis.view);
    Random random(3);
    for (int question = 0; question < 60; ++question) {
      const Vec3& centre = mesh.positions[random.below(static_cast<Index>(mesh.vertex_count()))];
      const double reach = 0.3 * random.unit();
      const Box box(Vec3(centre.array() - reach), Vec3(centre.array() + reach));
      std::vector<Index> expected;
      for (Index t = 0; t < analysis.view.triangles.size(); ++t) {
        Box bounds;
        for (const Index vertex : analysis.view.triangles[t]) bounds.extend(mesh.positions[vertex]);
        if (bounds.intersects(box)) expected.push_back(t);
      }
      CHECK(search.near(box) == expected);
    }
  }
}

TEST_CASE("clashes of a few triangles of a patch are those that a look at all of it finds") {
  const PolyMesh mesh = without_faces(round_sphere(3), std::vector<Index>{10, 11, 12, 13, 40, 41, 42});
  const HoleAnalysis analysis = analysis_of(mesh);
  const HoleSite site = make_site(mesh, analysis, std::vector<Index>{0}, {});
  const NearScene scene(site, Box(Vec3::Constant(-2), Vec3::Constant(2)));
  Random random(5);
  const auto somewhere = [&] { return Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)); };
  std::vector<Vec3> points;
  std::vector<std::array<Index, 3>> triangles;
  const auto first = static_cast<Index>(mesh.vertex_count());
  for (Index i = 0; i < 30; ++i) points.push_back(somewhere());
  for (Index i = 0; i + 2 < 30; ++i) triangles.push_back({first + i, first + i + 1, first + i + 2});
  triangles.push_back({site.vertices[0], site.vertices[1], first});
  Progress progress;
  const std::vector<Clash> all = scene.clashes(points, triangles, progress);
  REQUIRE(all.size() > 100);
  for (Index t = 0; t + 1 < triangles.size(); ++t) {
    const std::array chosen = {t, static_cast<Index>(triangles.size() - 1)};
    const auto is_chosen = [&](Index triangle) { return triangle == chosen[0] || triangle == chosen[1]; };
    const auto expected = std::ranges::count_if(
        all, [&](const Clash& clash) { return is_chosen(clash.triangle) || is_chosen(clash.other); });
    CHECK(scene.count_clashes_of(chosen, points, triangles, progress) == static_cast<std::size_t>(expected));
  }
}

TEST_CASE("many holes that ask what is near cost little more each in a large mesh") {
  const std::size_t few = boxes_looked_at(16), many = boxes_looked_at(64);  // 16 times the holes and triangles
  CHECK(many < 20 * few);
}

TEST_CASE("edges flipped so that triangles lie over others are flipped back") {
  const Site s = cross();
  Progress progress;
  const auto triangulation = triangulate_rim(s.site.polygon, progress);
  REQUIRE(triangulation);
  const HolePatch good = s.patch_of(triangulation->triangles);
  REQUIRE(s.is_sound(good));
  int tangled = 0;
  for (std::size_t triangle = 0; triangle < good.triangles.size(); ++triangle) {
    for (std::size_t side = 0; side < 3; ++side) {
      HolePatch patch = good;
      if (!flip(patch, triangle, side) || s.is_sound(patch)) continue;
      // Flat triangles may overlap without area, which no search of cuts sees: only what is seen is promised.
      const bool mended = untangle(s.site, patch, progress);
      CHECK(mended);
      tangled += s.is_sound(patch) ? 1 : 0;
    }
  }
  CHECK(tangled >= 2);
}

TEST_CASE("a sound patch is left as it is by untangling") {
  const Site s = cross();
  Progress progress;
  HolePatch patch = s.patch_of(triangulate_rim(s.site.polygon, progress)->triangles);
  const auto before = patch.triangles;
  CHECK(untangle(s.site, patch, progress));
  CHECK(patch.triangles == before);
}

TEST_CASE("triangles that would cut the surface are avoided where the least area would take them") {
  // A spike stands through the saddle that the least area makes of a rim with two high and two low corners.
  PolyMesh mesh = cut(sheet(10, 10), Vec3(5, 5, 0), 3.2).mesh;
  for (Vec3& p : mesh.positions) p.z() = 0.12 * ((p.x() - 5) * (p.x() - 5) - (p.y() - 5) * (p.y() - 5));
  Progress progress;
  const Index first = static_cast<Index>(mesh.vertex_count());
  for (const Vec3& p : {Vec3(4.6, 5.2, -3), Vec3(5.1, 4.7, -3), Vec3(5, 5.3, -3), Vec3(4.9, 5.1, 0.02)})
    mesh.positions.push_back(p);
  mesh.add_triangle(first, first + 1, first + 3);
  mesh.add_triangle(first + 1, first + 2, first + 3);
  mesh.add_triangle(first + 2, first, first + 3);
  mesh.add_triangle(first, first + 2, first + 1);
  const Site s(mesh, 1);
  const auto least = triangulate_rim(s.site.polygon, progress);
  REQUIRE(least);
  CHECK_FALSE(s.is_sound(s.patch_of(least->triangles)));
  const auto avoiding = avoiding_triangulation(s.site, progress);
  REQUIRE(avoiding);
  CHECK(s.is_sound(s.patch_of(*avoiding)));
}
