// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "hole_filling/site_scene.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

TEST_CASE("a site's memory changes no patch, and forgets what was made while other edges were free") {
  SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.4).mesh);
  Progress progress;
  const auto plain = smooth_patch(scene.site, false, progress);
  SiteMemory memory;
  scene.site.memory = &memory;
  const auto first = smooth_patch(scene.site, false, progress);
  REQUIRE(plain);
  REQUIRE(first);
  CHECK(first->points == plain->points);
  CHECK(first->triangles == plain->triangles);
  REQUIRE(memory.smooth.size() == 1);
  memory.smooth.begin()->second->points.pop_back();  // to be seen again
  CHECK(smooth_patch(scene.site, false, progress)->points.size() + 1 == plain->points.size());
  CHECK(fitted_once(scene.site, {})->fit == fitted_once(scene.site, {})->fit);
  scene.site.polygon.blocked = {{0, 2}};
  CHECK(smooth_patch(scene.site, false, progress)->points.size() == plain->points.size());
}

TEST_CASE("a patch to begin with lies between its rims' heights, whatever its size") {
  for (const double radius : {0.15, 0.4, 0.8}) {
    const SiteScene scene(cut(round_sphere(4), Vec3(0, 0, 1), radius).mesh);
    Progress progress;
    const auto patch = even_patch(scene.site, progress);
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
    REQUIRE(continues_curvature(scene.site));
    const auto few = fit_rims(scene.site, {});
    const auto all = fit_rims(scene.site, {.every_normal = true});
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
  CHECK_FALSE(continues_curvature(wide.site));
  SiteScene small(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  CHECK(continues_curvature(small.site));
  small.site.settings.implicit.kernel = implicit::Kernel::Triharmonic;
  CHECK_FALSE(continues_curvature(small.site));
  small.site.settings.implicit.kernel = implicit::Kernel::Hermite;
  small.site.settings.bulge = 0.5;
  CHECK_FALSE(continues_curvature(small.site));
}
