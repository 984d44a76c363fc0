// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

/// From a drawing to a solid, without any of the true solid's numbers.
using namespace croquis;
using namespace croquis::test;

namespace {

ReconstructedNetwork network_of(const SolidDrawing& truth) {
  Progress progress;
  return reconstruct_network(truth.drawing, {}, progress);
}

}  // namespace

TEST_CASE("drawings without noise become solids") {
  for (const PerspectiveSolid& test : all_solids()) {
    for (const View& view : all_views()) {
      SolidDrawingOptions options;
      options.vertex_ids = false;
      INFO(test.name << ", " << view.name);
      const ReconstructedNetwork network = network_of(drawn(test, view, options));
      const FaceFindingResult faces = faces_of(network.curves.network);
      CHECK(ids_of_faces(network.curves.network, faces.best) == ids_of_faces(test));
      Progress progress;
      const Solid solid = make_solid(network.curves.network, network.fitted, faces.best, progress);
      Progress report_progress;
      const MeshReport mesh = inspect(solid.tessellation.mesh, true, report_progress);
      CHECK(validate(solid.brep).empty());
      CHECK(mesh.closed);
      CHECK(mesh.euler_characteristic == 2 * (test.shells - test.genus));
      CHECK(mesh.self_intersections == 0);
    }
  }
}

TEST_CASE("drawings by hand have the faces of the solid") {
  for (const double noise : {2.0, 5.0, 10.0}) {
    for (const PerspectiveSolid& test : all_solids()) {
      // Its round stroke of two pieces gets a corner by noise, and with it another vertex.
      if (test.name == "D-block") continue;
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        INFO(test.name << ", noise " << noise << ", seed " << seed);
        SolidDrawingOptions options;
        options.noise = noise;
        options.seed = seed;
        const ReconstructedNetwork network = network_of(drawn(test, three_point_views()[1], options));
        const FaceFindingResult faces = faces_of(network.curves.network);
        CHECK(ids_of_faces(network.curves.network, faces.best) == ids_of_faces(test));
        Progress progress;
        CHECK(validate(make_solid(network.curves.network, network.fitted, faces.best, progress).brep).empty());
      }
    }
  }
}
