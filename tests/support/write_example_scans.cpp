// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the scan of examples/data: write_example_scans FOLDER
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <utility>

#include "croquis/io/mesh_file.h"
#include "support/random.h"
#include "support/scans.h"

namespace {

using namespace croquis;
using namespace croquis::test;

constexpr double ribs = 10;
constexpr double noise = 0.0015;  // of a radius of about 1, along it

/// 0 in a groove between two ribs, 1 on a rib's back; ribs run out at the poles.
double rib(const Vec3& on_sphere) {
  const double angle = std::atan2(on_sphere.y(), on_sphere.x());
  return std::abs(std::cos(ribs / 2 * angle)) * (1 - on_sphere.z() * on_sphere.z());
}

/// A pumpkin: ribs, flat, with a dent at both poles.
Vec3 sculpted(const Vec3& on_sphere) {
  const double dent = 0.45 * std::exp(-12 * (1 - std::abs(on_sphere.z())));
  const double radius = 0.9 + 0.12 * rib(on_sphere);
  return {radius * on_sphere.x(), radius * on_sphere.y(), on_sphere.z() * (0.75 - dent)};
}

AttributeChannel painted(const PolyMesh& on_sphere) {
  std::vector<std::uint8_t> values;
  for (const Vec3& p : on_sphere.positions) {
    const double light = 0.6 + 0.4 * rib(p);
    for (const double c : {235.0, 120.0, 30.0}) values.push_back(static_cast<std::uint8_t>(c * light));
  }
  return {"color", Domain::Vertex, 3, std::move(values), {}};
}

/// Three holes, and one with an island in it: five rims.
PolyMesh with_holes(const PolyMesh& on_sphere) {
  PolyMesh mesh = cut(on_sphere, Vec3(0.8, 0.5, 0.3).normalized(), 0.42).mesh;
  mesh = cut(mesh, Vec3(-0.7, 0.6, -0.2).normalized(), 0.25).mesh;
  mesh = cut(mesh, Vec3(-0.3, -0.2, 1).normalized(), 0.15).mesh;
  return cut_ring(mesh, Vec3(0.3, -0.9, 0.1).normalized(), 0.14, 0.34).mesh;
}

/// Vertices without a face go; the others keep their order.
PolyMesh without_loose_vertices(const PolyMesh& mesh) {
  std::vector<Index> number(mesh.vertex_count(), no_index);
  for (const Index v : mesh.corners) number[v] = 0;
  PolyMesh used;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(used.positions.size());
    used.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    used.add_triangle(number[mesh.face(f)[0]], number[mesh.face(f)[1]], number[mesh.face(f)[2]]);
  }
  return used;
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
  PolyMesh mesh = without_loose_vertices(with_holes(round_sphere(5)));
  mesh.channels.push_back(painted(mesh));
  Random random(5);
  for (Vec3& p : mesh.positions) {
    p = as_floats(sculpted(p) * (1 + noise * random.between(-1, 1)));
  }
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
