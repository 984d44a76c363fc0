// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/patching/avoiding_triangulation.h"
#include "algorithms/hole_filling/patching/untangling.h"
#include "croquis/hole_filling/patch_verification.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

struct Site {
  PolyMesh mesh;
  HoleAnalysis analysis;
  HoleSite site;

  Site(PolyMesh given, Index hole) : mesh(std::move(given)) {
    Progress progress;
    analysis = analyse_holes(mesh, progress);
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
