// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include <catch2/catch.hpp>

#include "croquis/perspective/solid.h"
#include "croquis/perspective/solid_network.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const AttributeCurve* curve_named(const AttributeNetwork& network, const std::string& id) {
  for (const AttributeCurve& curve : network.curves) {
    if (curve.id == id) return &curve;
  }
  return nullptr;
}

/// The corner at the start or end of a side.
Index node_of(const AttributeNetwork& network, const AttributeSide& side, bool at_end) {
  const AttributeCurve& curve = network.curves[side.curve];
  return side.reversed != at_end ? curve.to : curve.from;
}

}  // namespace

TEST_CASE("the network of a solid has its curves and its faces, closed and oriented outwards") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    const Brep brep = solid_of(test.network).brep;
    const SolidNetwork made = network_of_solid(brep);
    const AttributeNetwork& network = made.network;
    CHECK(validate(network).empty());
    // Each edge is its curve, or its two.
    std::size_t pieces = 0;
    for (const BrepEdge& edge : brep.edges) {
      for (std::size_t k = 0; k < edge.fitted.size(); ++k, ++pieces) {
        const std::string id = edge.fitted.size() == 1 ? edge.id : edge.id + "/" + std::to_string(k + 1);
        const AttributeCurve* curve = curve_named(network, id);
        REQUIRE(curve != nullptr);
        CHECK((curve->join == CurveJoin::Smooth) == edge.smooth);
        const std::vector<Vec3> control = control_polygon(network, *curve);
        for (const double t : {0.0, 0.25, 0.7, 1.0})
          CHECK((bezier_point(control, t) - edge.fitted[k].at(t)).norm() < 1e-12);
        CHECK(control.front() == network.nodes[curve->from].point);
        CHECK(control.back() == network.nodes[curve->to].point);
      }
    }
    CHECK(network.curves.size() == pieces);
    CHECK(network.nodes.size() == brep.vertices.size() + pieces - brep.edges.size());
    // Loops are closed; faces that meet in a curve run along it in opposite directions.
    std::map<std::pair<Index, bool>, int> uses;
    for (const AttributeFace& face : network.faces) {
      for (std::size_t i = 0; i < face.loop.size(); ++i) {
        const AttributeSide& next = face.loop[(i + 1) % face.loop.size()];
        CHECK(node_of(network, face.loop[i], true) == node_of(network, next, false));
        ++uses[{face.loop[i].curve, face.loop[i].reversed}];
      }
    }
    for (const auto& [use, count] : uses) CHECK(count == 1);
    std::size_t with_holes = 0;
    for (const BrepFace& face : brep.faces) with_holes += face.loops.size() > 1 ? 1U : 0U;
    CHECK(made.warnings.size() == with_holes);
    CHECK(network.faces.size() == brep.faces.size() - with_holes);
    if (with_holes == 0) CHECK(uses.size() == 2 * network.curves.size());
  }
}

TEST_CASE("faces that a network can't have are named and left out") {
  const SolidNetwork made = network_of_solid(solid_of(camera_body().network).brep);
  REQUIRE(made.warnings.size() == 1);
  CHECK(made.warnings[0].code == "FACE_LEFT_OUT");
  CHECK(made.warnings[0].subjects.at(0).kind == SubjectKind::Face);
  CHECK(made.warnings[0].message.find("hole") != std::string::npos);
  Brep star;  // a disc of 13 sides and its back
  for (int i = 0; i < 13; ++i) star.vertices.push_back({Vec3(std::cos(i * 0.48), std::sin(i * 0.48), 0), 0});
  for (Index i = 0; i < 13; ++i) {
    const Index end = (i + 1) % 13;
    const RationalCubic line = straight_cubic(star.vertices[i].point, star.vertices[end].point);
    star.edges.push_back({"e" + std::to_string(i), i, i, end, {line}, {line}, true, {i, 13 + i}, false, {}});
  }
  for (Index i = 0; i < 13; ++i) star.half_edges.push_back({i, false, 0, (i + 1) % 13});
  for (Index i = 0; i < 13; ++i) star.half_edges.push_back({i, true, 1, 13 + (i + 12) % 13});
  star.loops = {{0, 0}, {1, 13}};
  star.faces.resize(2);
  for (Index f = 0; f < 2; ++f) star.faces[f].shell = 0, star.faces[f].loops = {f};
  star.shells = {{{0, 1}, true, false}};
  REQUIRE(validate(star).empty());
  const SolidNetwork open = network_of_solid(star);
  CHECK(open.network.faces.empty());
  CHECK(open.network.curves.size() == 13);
  REQUIRE(open.warnings.size() == 2);
  CHECK(open.warnings[0].message.find("13 sides") != std::string::npos);
}
