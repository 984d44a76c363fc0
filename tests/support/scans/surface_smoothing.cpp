// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/surface_smoothing.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

/// 1 at the ends of edges that don't have exactly two faces.
std::vector<std::uint8_t> ends_of_open_edges(const PolyMesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const Index a = mesh.corners[c];
    const Index b = mesh.corners[c % 3 == 2 ? c - 2 : c + 1];
    edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint8_t> open(mesh.vertex_count(), 0);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end - i != 2) open[edges[i][0]] = open[edges[i][1]] = 1;
    i = end;
  }
  return open;
}

/// The mean of the triangles' centroids, weighted by area, once for all vertices.
void move_to_centroids(PolyMesh& mesh, const std::vector<std::uint8_t>& open) {
  std::vector<Vec3> sums(mesh.vertex_count(), Vec3::Zero());
  std::vector<double> areas(mesh.vertex_count(), 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vec3& a = mesh.positions[face[0]];
    const Vec3& b = mesh.positions[face[1]];
    const Vec3& c = mesh.positions[face[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const Vec3 weighted = area / 3 * ((b - a) + (c - a));  // from a, for the digits of meshes far away
    for (const Index v : face) {
      sums[v] += weighted + area * (a - mesh.positions[v]);
      areas[v] += area;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (open[v] != 0 || !(areas[v] > 0)) continue;
    mesh.positions[v] += sums[v] / areas[v];
  }
}

}  // namespace

implicit::ProjectionReport smooth_on_surface(PolyMesh& mesh, const implicit::Field& field, int rounds,
                                             const implicit::ProjectionOptions& options) {
  const std::vector<std::uint8_t> open = ends_of_open_edges(mesh);
  implicit::ProjectionReport report;
  for (int round = 0; round < rounds; ++round) {
    move_to_centroids(mesh, open);
    report = project(mesh.positions, open, field, options);
  }
  return report;
}

}  // namespace croquis::test
