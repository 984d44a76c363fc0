// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;

TEST_CASE("the measures know an exact torus and see a dent in its rim") {
  PolyMesh torus = test::triangulated(test::torus(96, 48));
  CHECK(test::vertical_hits(torus, {1.01, 0.02}).size() == 2);
  CHECK(test::vertical_hits(torus, {0.01, 0.02}).empty());
  const double smooth = test::rim_serration(torus).p95;
  for (std::size_t v = 0; v < torus.positions.size(); v += 5) torus.positions[v].z() += 0.02;
  CHECK(test::rim_serration(torus).p95 > smooth + 1);
}

TEST_CASE("rims are smooth and have no notches where others cross them") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    const Solid solid = test::solid_of(named.sketch.drawing);
    const test::Spread serration = test::rim_serration(solid.mesh);
    CHECK(serration.p95 <= 1);
    CHECK(serration.mean <= 0.5);
    // Rows lie 20 degrees apart, seen from the axis, and half of that is a facet's own error: a notch of a row left out
    // is 30 degrees and more, one of a few degrees is hidden by the sampling.
    CHECK(test::deepest_rim_notch(solid.mesh) <= 25);
  }
}

TEST_CASE("no notch comes and goes with the last digits of a drawing") {
  const test::Sketch drawn = test::dog_sketch();
  for (int k = 1; k <= 4; ++k) {
    INFO(k);
    const Solid solid = test::solid_of(test::rotated(drawn, 0.001 * k).drawing);
    CHECK(test::deepest_rim_notch(solid.mesh) <= 25);
  }
}

TEST_CASE("of a hundred triangles hardly one has an angle below 15 degrees") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    const Solid solid = test::solid_of(named.sketch.drawing);
    CHECK(test::slender_share(solid.mesh) <= 0.01);
    CHECK(test::smallest_angles(solid.mesh).front() > 1);
  }
}

TEST_CASE("sections normal to inclined tubes are circles") {
  for (const test::Sketch& sketch :
       {test::trefoil_sketch(), test::figure_eight_sketch(), test::snake_sketch(), test::weave_sketch(),
        test::duck_sketch(), test::dog_sketch(), test::octopus_sketch()}) {
    const Solid solid = test::solid_of(sketch.drawing);
    const std::vector<double> ratios = test::half_axis_ratios(solid.mesh, solid.skeleton);
    REQUIRE(ratios.size() > 10);
    CHECK(*std::min_element(ratios.begin(), ratios.end()) >= 0.97);
    CHECK(*std::max_element(ratios.begin(), ratios.end()) <= 1.03);
  }
}

TEST_CASE("the rim of a capsule is part of a circle to a hundredth of its radius") {
  const Solid solid = test::solid_of(test::capsule_figure());
  const double radius = 40;
  const auto bounds = *test::report_of(solid.mesh).bounds;
  const double middle = (bounds[0].z() + bounds[1].z()) / 2;
  std::vector<double> deviations;
  for (std::size_t f = 0; f < solid.mesh.face_count(); ++f) {
    Vec3 centre = Vec3::Zero();
    for (const Index v : solid.mesh.face(f)) centre += solid.mesh.positions[v] / 3;
    // The straight part, and there the outer half of the radius.
    if (centre.x() < 60 || centre.x() > 160 || std::abs(centre.y()) < radius / 2) continue;
    const double distance = std::hypot(centre.y(), centre.z() - middle);
    deviations.push_back(std::abs(distance - radius) / radius);
  }
  REQUIRE(deviations.size() > 200);
  CHECK(test::spread_of(deviations).max <= 0.02);
  CHECK(test::spread_of(deviations).mean <= 0.01);
}
