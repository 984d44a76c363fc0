// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "step/read_step.h"
#include "step/step_file.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Fine enough for volumes.
SolidOptions fine() {
  SolidOptions options;
  options.tessellation.chord_tolerance = 0.00002;
  return options;
}

Solid solid_of(const CurveNetwork& network) {
  Progress progress;
  return make_solid(network, polynomial_pieces(network), faces_of(network).best, progress, fine());
}

Solid drawn_solid(const std::string& name) {
  Progress progress;
  const std::string path = CROQUIS_DRAWINGS "/" + name;
  const PerspectiveDrawing drawing = read_perspective_svg(read_file(path), path, progress).drawing;
  const ReconstructedNetwork network = reconstruct_network(drawing, {}, progress);
  return make_solid(network.curves.network, network.fitted, find_faces(network.curves.network, progress).best, progress,
                    fine());
}

double volume_of(const Solid& solid) {
  return std::accumulate(solid.tessellation.volume.begin(), solid.tessellation.volume.end(), 0.0);
}

StepFile step_of(const Brep& brep, const StepOptions& options = {}) {
  Progress progress;
  return write_step(brep, options, progress);
}

/// Faces and edges of a file: stars of patches count as many faces, with lines to their middles.
struct Expected {
  std::size_t faces = 0, edges = 0, planes = 0;
};

Expected expected_of(const Brep& brep) {
  Expected result{0, brep.edges.size(), 0};
  for (const BrepFace& face : brep.faces) {
    result.faces += std::max<std::size_t>(1, face.patches.size());
    result.planes += face.planar ? 1U : 0U;
    if (face.patches.size() > 1) result.edges += face.patches.size();
  }
  for (const BrepEdge& edge : brep.edges) {
    const bool cut = std::ranges::any_of(edge.half_edges, [&](Index half) {
      return half != no_index && brep.faces[brep.face_of(half)].patches.size() > 1;
    });
    result.edges += cut ? 1U : 0U;
  }
  return result;
}

void check_file(const Solid& solid, double volume_factor = 1, const StepOptions& options = {}) {
  const StepFile file = step_of(solid.brep, options);
  const ReadSolid read = read_step(file.bytes);
  const Expected expected = expected_of(solid.brep);
  CHECK(read.valid);
  CHECK(read.closed);
  CHECK(read.shells == solid.brep.shells.size());
  CHECK(read.faces == expected.faces);
  CHECK(read.edges == expected.edges);
  CHECK(file.faces == expected.faces);
  CHECK(file.edges == expected.edges);
  CHECK(read.planes == expected.planes);
  CHECK(file.error <= 1e-4 * size_of(solid.brep));
  CHECK(read.volume == Approx(volume_factor * volume_of(solid)).epsilon(1e-4));
}

}  // namespace

TEST_CASE("STEP files of all test solids are closed, valid and have their volumes") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    check_file(solid_of(test.network));
  }
}

TEST_CASE("STEP files of balls of arcs are smooth and closed") {
  for (const PolyhedronNet& net : sphere_nets()) {
    INFO(net.name);
    check_file(solid_of(net.network));
  }
}

TEST_CASE("STEP files of the shipped drawings are valid") {
  for (const char* name : {"bottle.svg", "bracket.svg", "camera.svg", "frame.svg", "soap.svg"}) {
    INFO(name);
    const Solid solid = drawn_solid(name);
    check_file(solid);
    CHECK(read_step(step_of(solid.brep).bytes).solids == 1);
  }
}

TEST_CASE("straight edges are lines in STEP, planes planes, rational curves rational") {
  const ReadSolid plain = read_step(step_of(solid_of(box().network).brep).bytes);
  CHECK(plain.lines == 12);
  CHECK(plain.planes == 6);
  CHECK(plain.volume == Approx(24).epsilon(1e-12));

  // A cylinder of exact circles: quarters with the weights of rational cubics.
  CurveNetwork network = cylinder().network;
  for (NetworkCurve& curve : network.curves) {
    for (RationalCubic& piece : curve.pieces) {
      if (std::abs(piece.points[0].z() - piece.points[3].z()) > 1e-9 || curve.straight) continue;
      const Vec3 apex = piece.points[0] + (piece.points[1] - piece.points[0]) / 0.5522847498307936;
      const double w = std::sqrt(0.5);
      piece.weights = {1, (1 + 2 * w) / 3, (1 + 2 * w) / 3, 1};
      piece.points[1] = (piece.points[0] + 2 * w * apex) / (1 + 2 * w);
      piece.points[2] = (piece.points[3] + 2 * w * apex) / (1 + 2 * w);
    }
  }
}

TEST_CASE("cavities are voids of their solids, also of the right one of two") {
  const CurveNetwork hollow = joined(box().network, moved(box().network, 0.4, Vec3(1, 1, 0.5)), "inner");
  const Solid one = solid_of(hollow);
  check_file(one);
  CHECK(read_step(step_of(one.brep).bytes).solids == 1);

  const Solid two = solid_of(joined(hollow, moved(box().network, 1, Vec3(10, 0, 0)), "other"));
  check_file(two);
  CHECK(read_step(step_of(two.brep).bytes).solids == 2);
}

TEST_CASE("STEP files are in the unit that is asked for") {
  const Solid solid = solid_of(soap().network);
  const std::vector<std::pair<LengthUnit, double>> units = {
      {LengthUnit::Millimetre, 1}, {LengthUnit::Centimetre, 10}, {LengthUnit::Metre, 1000}, {LengthUnit::Inch, 25.4}};
  for (const auto& [unit, millimetres] : units) {
    StepOptions options;
    options.unit = unit;
    check_file(solid, std::pow(millimetres, 3), options);
  }
  CHECK(length_unit_named("cm") == LengthUnit::Centimetre);
  CHECK(!length_unit_named("furlong"));
}

TEST_CASE("STEP files name strokes, faces and the product, and are the same each time") {
  const Solid solid = solid_of(bottle().network);
  StepOptions options;
  options.name = "bottle";
  for (std::size_t f = 0; f < solid.brep.faces.size(); ++f) options.face_names.push_back("f" + std::to_string(f));
  const StepFile file = step_of(solid.brep, options);
  for (const BrepEdge& edge : solid.brep.edges) {
    INFO(edge.id);
    CHECK(file.bytes.find("EDGE_CURVE('" + edge.id + "'") != std::string::npos);
  }
  for (const std::string& name : options.face_names) {
    INFO(name);
    CHECK(file.bytes.find("ADVANCED_FACE('" + name + "'") != std::string::npos);
  }
  CHECK(file.bytes.find("PRODUCT('bottle','bottle'") != std::string::npos);
  CHECK(step_of(solid.brep, options).bytes == file.bytes);
}

TEST_CASE("an open shell stays open in STEP") {
  const Solid solid =
      solid_of(line_network({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  const ReadSolid read = read_step(step_of(solid.brep).bytes);
  CHECK(read.valid);
  CHECK(!read.closed);
  CHECK(read.solids == 0);
  CHECK(read.faces == 1);
}

TEST_CASE("writing STEP can be cancelled") {
  const std::atomic<bool> cancel = true;
  Progress progress({}, &cancel);
  CHECK_THROWS_AS(write_step(solid_of(bottle().network).brep, {}, progress), Cancelled);
}
