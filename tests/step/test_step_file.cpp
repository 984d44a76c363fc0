// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>

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
  options.tessellation.chord_tolerance = 0.00005;
  return options;
}

Solid drawn_solid(const std::string& name) {
  Progress progress;
  const std::string path = CROQUIS_DRAWINGS "/" + name;
  const PerspectiveDrawing drawing = read_perspective_svg(read_file(path), path, progress).drawing;
  const ReconstructedNetwork network = reconstruct_network(drawing, {}, progress);
  return make_solid(network.curves.network, network.fitted, find_faces(network.curves.network, progress).best, progress,
                    fine());
}

/// The cone from the origin over a patch, by midpoints.
double volume_under(const GregoryPatch& patch) {
  constexpr int cells = 64;
  double volume = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const PatchPoint p = patch.at((i + 0.5) / cells, (j + 0.5) / cells);
      volume += p.at.dot(p.du.cross(p.dv)) / (3.0 * cells * cells);
    }
  }
  return volume;
}

/// Planes by the triangles of the mesh, patches as they are: meshes of round solids are smaller.
double volume_of(const Solid& solid) {
  const PolyMesh& mesh = solid.tessellation.mesh;
  const auto& faces = std::get<std::vector<std::int32_t>>(mesh.channel("group", Domain::Face)->data);
  double volume = 0;
  for (std::size_t t = 0; t < mesh.face_count(); ++t) {
    if (!solid.brep.faces[static_cast<std::size_t>(faces[t])].planar) continue;
    const auto corners = mesh.face(t);
    const Vec3 &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]], &c = mesh.positions[corners[2]];
    volume += a.dot(b.cross(c)) / 6;
  }
  for (const BrepFace& face : solid.brep.faces) {
    for (const GregoryPatch& patch : face.patches) volume += volume_under(patch);
  }
  return volume;
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

ReadSolid check_file(const Solid& solid, double volume_factor = 1, const StepOptions& options = {}) {
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
  return read;
}

}  // namespace

TEST_CASE("STEP files of all test solids are closed, valid and have their volumes") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    check_file(solid_of(test.network, fine()));
  }
}

TEST_CASE("STEP files of balls of arcs are smooth and closed") {
  for (const PolyhedronNet& net : sphere_nets()) {
    INFO(net.name);
    check_file(solid_of(net.network, fine()));
  }
}

TEST_CASE("STEP files of the shipped drawings are valid") {
  for (const char* name : {"bottle.svg", "bracket.svg", "camera.svg", "frame.svg", "soap.svg"}) {
    INFO(name);
    CHECK(check_file(drawn_solid(name)).solids == 1);
  }
}

TEST_CASE("straight edges are lines in STEP, planes planes") {
  const ReadSolid plain = read_step(step_of(solid_of(box().network, fine()).brep).bytes);
  CHECK(plain.lines == 12);
  CHECK(plain.planes == 6);
  CHECK(plain.volume == Approx(24).epsilon(1e-12));
}

TEST_CASE("rational curves stay exact in STEP: a quarter of a disc has the area of one") {
  CurveNetwork network = line_network({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 0}});
  NetworkCurve& arc = network.curves[1];
  const double w = std::sqrt(0.5), middle = (1 + 2 * w) / 3, near = 2 * w / (1 + 2 * w);
  arc.straight = false;
  arc.pieces = {{{Vec3(1, 0, 0), Vec3(1, near, 0), Vec3(near, 1, 0), Vec3(0, 1, 0)}, {1, middle, middle, 1}}};
  CHECK(arc.pieces[0].at(0.3).norm() == Approx(1).epsilon(1e-15));
  const ReadSolid read = read_step(step_of(solid_of(network, fine()).brep).bytes);
  CHECK(read.valid);
  CHECK(read.rational_edges == 1);
  CHECK(read.lines == 2);
  CHECK(area_in_step(step_of(solid_of(network, fine()).brep).bytes) == Approx(std::numbers::pi / 4).epsilon(1e-9));

  // In two pieces that meet with other weights.
  const auto [first, second] = arc.pieces[0].split(0.3);
  arc.pieces = {first, second};
  for (double& weight : arc.pieces[1].weights) weight *= 3;
  const ReadSolid pieces = read_step(step_of(solid_of(network, fine()).brep).bytes);
  CHECK(pieces.valid);
  CHECK(area_in_step(step_of(solid_of(network, fine()).brep).bytes) == Approx(std::numbers::pi / 4).epsilon(1e-9));
}

TEST_CASE("cavities are voids of their solids, also of the right one of two") {
  const CurveNetwork hollow = joined(box().network, moved(box().network, 0.4, Vec3(1, 1, 0.5)), "inner");
  CHECK(check_file(solid_of(hollow, fine())).solids == 1);

  CHECK(check_file(solid_of(joined(hollow, moved(box().network, 1, Vec3(10, 0, 0)), "other"))).solids == 2);
}

TEST_CASE("STEP files are in the unit that is asked for") {
  const Solid solid = solid_of(soap().network, fine());
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
  const Solid solid = solid_of(bottle().network, fine());
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
  CHECK((step_of(solid.brep, options).bytes == file.bytes));  // too long to be shown
}

TEST_CASE("an open shell stays open in STEP") {
  const Solid solid =
      solid_of(line_network({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}), fine());
  const ReadSolid read = read_step(step_of(solid.brep).bytes);
  CHECK(read.valid);
  CHECK(!read.closed);
  CHECK(read.solids == 0);
  CHECK(read.faces == 1);
}

TEST_CASE("writing STEP can be cancelled") {
  const std::atomic<bool> cancel = true;
  Progress progress({}, &cancel);
  CHECK_THROWS_AS(write_step(solid_of(bottle().network, fine()).brep, {}, progress), Cancelled);
}

TEST_CASE("a solid without faces is refused as STEP") {
  try {
    step_of({});
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.findings()[0].code == "E_STEP_FILE");
    CHECK(error.findings()[0].category == Category::Geometry);
  }
}
