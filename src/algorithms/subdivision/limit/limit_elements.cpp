// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/subdivision/limit.h"

namespace croquis::subdivision {
namespace {

/// Cross product of the two Fourier modes of first order, on the side that the face is seen from.
Vec3 fourier_normal(const HalfEdges& mesh, std::span<const Vec3> positions, Index face) {
  const auto vertices = mesh.face(face);
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
  for (std::size_t j = 0; j < vertices.size(); ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(vertices.size());
    first += std::cos(angle) * positions[vertices[j]];
    second += std::sin(angle) * positions[vertices[j]];
  }
  const Vec3 normal = first.cross(second);
  return unit_or_zero(normal.dot(area_normal(positions, mesh.face(face))) < 0 ? Vec3(-normal) : normal);
}

/// Vertices at which exactly two edges are sharp and nothing is pinned.
std::vector<bool> crease_vertices(const Level& level, std::span<const double> sharpness) {
  const HalfEdges& mesh = level.topology;
  std::vector<int> count(mesh.vertex_count(), 0);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    if (sharpness[mesh.corner_edge[corner]] >= 1) ++count[mesh.corner_vertex[corner]];
  }
  for (const Index corner : level.boundary) count[mesh.corner_vertex[corner]] += 2;  // no chain runs along there
  std::vector<bool> result(mesh.vertex_count());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = count[v] == 2;
  for (const Index pin : level.pins) result[pin] = false;
  return result;
}

Vec3 side_normal(const HalfEdges& mesh, std::span<const Vec3> positions, Index face, Index from, Index to) {
  const auto vertices = mesh.face(face);
  Vec3 across = -positions[from] - positions[to];
  for (const Index vertex : vertices) {
    if (vertex != from && vertex != to) across += 2 / static_cast<double>(vertices.size() - 2) * positions[vertex];
  }
  return unit_or_zero((positions[to] - positions[from]).cross(across));
}

}  // namespace

FaceLimits face_limits(const Level& level, std::span<const Vec3> positions) {
  const HalfEdges& mesh = level.topology;
  const std::vector<double> sharpness = edge_sharpness(level);
  FaceLimits limits;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    Vec3 centre = Vec3::Zero();
    bool smooth = true;
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + std::size_t{1}]; ++corner) {
      centre += positions[mesh.corner_vertex[corner]];
      smooth = smooth && sharpness[mesh.corner_edge[corner]] == 0;
    }
    limits.points.push_back(centre / static_cast<double>(mesh.face(face).size()));
    limits.normals.push_back(fourier_normal(mesh, positions, face));
    limits.exact.push_back(smooth ? 1 : 0);
  }
  return limits;
}

std::vector<EdgeLimit> sharp_edge_limits(const Level& level, std::span<const Vec3> positions) {
  const HalfEdges& mesh = level.topology;
  const CornerFaces around(mesh);
  const std::vector<bool> within_chain = crease_vertices(level, edge_sharpness(level));
  std::vector<EdgeLimit> limits;
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = mesh.edge_corner[sharp.edge];
    const Index a = mesh.corner_vertex[corner], b = mesh.corner_vertex[mesh.twin[corner]];
    const Index left = around.face(corner), right = around.face(mesh.twin[corner]);
    EdgeLimit& limit = limits.emplace_back();
    limit.point = (positions[a] + positions[b]) / 2;
    limit.tangent = unit_or_zero(positions[b] - positions[a]);
    limit.normals = {side_normal(mesh, positions, left, a, b), side_normal(mesh, positions, right, b, a)};
    limit.exact = sharp.sharpness == infinite_sharpness && within_chain[a] && within_chain[b] &&
                  mesh.face(left).size() == 4 && mesh.face(right).size() == 4;
  }
  return limits;
}

}  // namespace croquis::subdivision
