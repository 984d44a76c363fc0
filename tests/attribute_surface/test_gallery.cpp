// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "attribute_surface/small_networks.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "support/attribute_surface/gallery.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {

TEST_CASE("the gallery's networks are shipped as they are written") {
  for (const AttributeNetwork& network : gallery_networks()) {
    const std::string path = CROQUIS_SOURCE_DIR "/examples/data/surface/" + network.name + ".json";
    CHECK(read_file(path) == write_attribute_network(network));
  }
}

TEST_CASE("the gallery's networks become surfaces without a finding, but for the dinghy's stem") {
  for (const AttributeNetwork& network : gallery_networks()) {
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    for (const SurfaceFace& face : surface.faces) CHECK(face.surface);
    for (const Finding& finding : surface.findings) {
      CAPTURE(finding.message);
      CHECK(finding.code == "W_SMOOTH_CONFLICT");
      CHECK(network.name == "dinghy");
    }
    for (std::size_t c = 0; c < network.curves.size(); ++c)
      CHECK(surface.curves[c].smooth == (network.curves[c].join == CurveJoin::Smooth));
  }
}

TEST_CASE("the smooth keel of a hull is no knife edge away from the stem") {
  const AttributeNetwork hull = boat_hull();
  const AttributeSurface surface = surface_of(hull);
  REQUIRE(surface.findings.size() == 1);
  CHECK(surface.findings[0].code == "W_SMOOTH_CONFLICT");
  for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec3 left = surface.faces[0].surface->side_normal(0, fraction);
    const Vec3 right = surface.faces[1].surface->side_normal(2, 1 - fraction);
    CHECK((left - right).norm() < 1e-12);
    // A hull looks the same from both sides.
    CHECK(std::abs(left.y()) < 1e-6);
  }
}

TEST_CASE("a strongly concave loop is told of, and evaluated all the same") {
  const AttributeSurface surface = surface_of(l_loop());
  REQUIRE(surface.findings.size() == 1);
  CHECK(surface.findings[0].code == "W_FOLD");
  CHECK(surface.any());
}

TEST_CASE("a curve of three faces is told of with their number and names") {
  AttributeNetwork network = leaf_between_triangles();
  AttributeFace fin = network.faces[1];
  fin.id = "fin";
  network.faces.push_back(fin);
  std::vector<std::string> sentences;
  for (const Finding& finding : surface_of(network).findings) {
    if (finding.code != "W_NONMANIFOLD") continue;
    sentences.push_back(finding.message.substr(0, finding.message.find(':')));
    CHECK(finding.subjects.size() == 4);
  }
  CHECK(sentences == std::vector<std::string>{"Curve \"c0\" belongs to 3 faces"});
}

}  // namespace croquis::test
