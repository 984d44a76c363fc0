// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the files of examples/data that are generated: write_examples FOLDER
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "croquis/io/attribute_network_file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/attribute_surface/gallery.h"
#include "support/meshes/mesh_shapes.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"
#include "support/scans/solid_shapes.h"
#include "support/scans/virtual_scans.h"
#include "support/sketches/sketch_generator.h"

namespace croquis::test {
namespace {

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.good()) throw std::runtime_error("can't write " + path.string());
}

// ---- Sketches

/// @param part names the strokes: "ring-1", "ring-2"
std::string sketch_file(Drawing drawing, const std::string& part) {
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    drawing.strokes[i].id = part + '-' + std::to_string(i + 1);
  }
  SvgStyle style;
  style.curves = SvgCurves::Cubic;
  style.decimals = 2;
  style.tolerance = 0.1;
  style.shift = true;
  return to_svg(drawing, style);
}

void write_sketches(const std::filesystem::path& folder) {
  const auto add = [&](const std::string& name, const std::string& part, const Drawing& drawing) {
    write(folder / (name + ".svg"), sketch_file(drawing, part));
  };
  add("trefoil", "tube", trefoil_sketch().drawing);
  add("snake", "snake", snake_sketch().drawing);
  add("ring_and_bar", "line", ring_and_bar_sketch().drawing);
  add("linked_rings", "ring", linked_rings_sketch().drawing);
  add("borromean", "ring", borromean_sketch().drawing);
  add("chain", "link", chain_sketch().drawing);
  add("weave", "bar", weave_sketch().drawing);
  add("knot_3_4", "tube", torus_knot_sketch(3, 4).drawing);
  add("dog", "dog", dog_sketch().drawing);
  add("duck", "duck", duck_sketch().drawing);
  add("octopus", "octopus", octopus_sketch().drawing);
  add("noisy_trefoil", "pen", noisy(trefoil_sketch().drawing, 4));
}

// ---- Drawings in perspective

/// As a careful hand would draw them: ends miss each other by less than a pixel, nobody writes down which ones meet.
void write_drawings(const std::filesystem::path& folder) {
  SolidDrawingOptions by_hand;
  by_hand.noise = 0.6;
  by_hand.end_jitter = 0.4;
  by_hand.construction_lines = 4;
  by_hand.vertex_ids = false;
  by_hand.hidden = true;
  const auto add = [&](const std::string& name, const PerspectiveSolid& solid, const View& view) {
    write(folder / (name + ".svg"), write_perspective_svg(drawn(solid, view, by_hand).drawing));
  };
  add("bottle", bottle(), View{});
  add("camera", camera_body(), View{});
  add("soap", soap(), off_centre_view());
  add("frame", ring_frame(), View{});
  add("bracket", l_block(), level_view());
}

// ---- The scan of a pumpkin

constexpr std::size_t pumpkin_triangles = 26000;
constexpr double pumpkin_noise = 0.03;  // of an edge
constexpr double floor_height = -0.36;  // what is below hasn't been seen

/// 0 in a groove between two ribs, 1 on a rib's back; ribs run out at the poles. The axis is y.
double rib(const Vec3& p) {
  constexpr double ribs = 10;
  const double across = std::hypot(p.x(), p.z());
  const double steepness = p.y() / std::hypot(across, p.y() / 0.75) / 0.75;
  return std::sqrt(std::abs(std::cos(ribs / 2 * std::atan2(p.z(), p.x())))) * (1 - steepness * steepness);
}

/// Flat, with a dent at both poles.
double body(const Vec3& p) {
  const double across = std::hypot(p.x(), p.z());
  const double dent = 0.22 * std::exp(-across * across / 0.09);
  const double height = std::abs(p.y()) + dent;
  return 0.85 * (std::hypot(across, height / 0.78) - 0.86 - 0.13 * rib(p));
}

/// Bent, with five edges, wide where it grows out.
double stem(const Vec3& p) {
  const double along = (p.y() - 0.42) / 0.6;
  const double lean = 0.22 * along * along;
  const double x = p.x() - lean, z = p.z() + 0.4 * lean;
  const double radius = 0.1 + 0.12 * std::exp(-6 * std::max(along, 0.0)) + 0.02 * std::max(along, 0.0);
  const double edges = 1 + 0.12 * std::cos(5 * std::atan2(z, x) + 1.5 * along);
  return 0.8 * -blend(radius * edges - std::hypot(x, z), 0.6 * (1 - along), 0.05);
}

double solid(const Vec3& p) {
  return std::max(blend(body(p), std::max(stem(p), 0.35 - p.y()), 0.06), floor_height - p.y());
}

AttributeChannel painted(const PolyMesh& mesh) {
  std::vector<std::uint8_t> values;
  for (const Vec3& p : mesh.positions) {
    const double green = 1 / (1 + std::exp(-40 * (body(p) - 0.025)));
    const double light = 0.55 + 0.45 * rib(p);
    const double pale = 0.06 * std::sin(23 * p.x()) * std::sin(19 * p.y()) * std::sin(21 * p.z());
    const Vec3 orange = Vec3(238, 118, 22) * (light + pale), stalk = Vec3(112, 122, 58) * (0.9 + 2 * pale);
    const Vec3 color = (1 - green) * orange + green * stalk;
    for (const double c : color) values.push_back(static_cast<std::uint8_t>(std::clamp(c, 0.0, 255.0)));
  }
  return {"color", Domain::Vertex, 3, std::move(values), {}};
}

/// The underside can't be seen: the rest ends in a plane rim.
PolyMesh without_floor(const PolyMesh& mesh) {
  std::vector<Index> floor;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    if (std::all_of(t.begin(), t.end(), [&](Index v) { return mesh.positions[v].y() < floor_height + 1e-3; }))
      floor.push_back(f);
  }
  return without_faces(mesh, floor);
}

/// Ragged holes of four sizes, and one with an island in it.
PolyMesh with_holes(PolyMesh mesh) {
  mesh = cut_ragged(mesh, {0.95, 0.05, 0.25}, 0.32, 0, 4);
  mesh = cut_ragged(mesh, {-0.3, 0.5, -0.6}, 0.22, 0, 5);
  mesh = cut_ragged(mesh, {-0.5, 0.5, 0.4}, 0.12, 0, 7);
  mesh = cut_ragged(mesh, {0.6, 0.45, 0.55}, 0.06, 0, 9);
  return cut_ragged(mesh, {0.15, 0.05, 0.95}, 0.3, 0.12, 11);
}

/// Volatile: GCC 12 may drop the rounding to 32 bits and back.
Vec3 as_floats(Vec3 point) {
  for (double& coordinate : point) {
    const volatile float rounded = static_cast<float>(coordinate);
    coordinate = static_cast<double>(rounded);
  }
  return point;
}

PolyMesh pumpkin() {
  PolyMesh mesh = without_loose_vertices(with_holes(without_floor(sculpt(solid, pumpkin_triangles))));
  mesh.channels.push_back(painted(mesh));
  mesh = with_noise(mesh, 5, pumpkin_noise);
  for (Vec3& p : mesh.positions) p = as_floats(p);
  return mesh;
}

}  // namespace
}  // namespace croquis::test

int main(int argc, char** argv) {
  using namespace croquis::test;
  if (argc != 2) {
    std::cerr << "usage: write_examples FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    write_sketches(folder);
    write_drawings(folder / "perspective");
    for (const croquis::AttributeNetwork& network : gallery_networks())
      write(folder / "surface" / (network.name + ".json"), croquis::write_attribute_network(network));
    croquis::Progress progress;
    write(folder / "pumpkin_scan.ply", write_mesh(pumpkin(), croquis::MeshFormat::Ply, {}, progress).bytes);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
