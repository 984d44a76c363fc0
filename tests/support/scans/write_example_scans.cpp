// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the scan of examples/data: write_example_scans FOLDER
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <utility>

#include "croquis/io/mesh_file.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/virtual_scans.h"

namespace {

using namespace croquis;
using namespace croquis::test;

constexpr std::size_t triangles = 26000;
constexpr double noise = 0.03;          // of an edge
constexpr double floor_height = -0.36;  // what is below hasn't been seen

double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k / 4;
}

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
  PolyMesh mesh = without_loose_vertices(with_holes(without_floor(sculpt(solid, triangles))));
  mesh.channels.push_back(painted(mesh));
  mesh = with_noise(mesh, 5, noise);
  for (Vec3& p : mesh.positions) p = as_floats(p);
  return mesh;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_example_scans FOLDER\n";
    return 2;
  }
  Progress progress;
  std::ofstream file(std::string(argv[1]) + "/pumpkin_scan.ply", std::ios::binary);
  file << write_mesh(pumpkin(), MeshFormat::Ply, {}, progress).bytes;
  file.close();
  if (!file) std::cerr << "the scan could not be written to " << argv[1] << '\n';
  return file ? 0 : 1;
}
