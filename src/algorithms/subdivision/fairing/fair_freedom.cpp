// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/fairing/fair_freedom.h"

#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/subdivision/cage/face_cutting.h"
#include "algorithms/subdivision/cage/tag_changes.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/subdivision/shape_keeping.h"

namespace croquis::subdivision {
namespace {

/// Sine of the angle below which two planes count as one.
constexpr double same_plane = 1e-6;

/// Leaves of the directions those at right angles to a normal.
void remove_direction(const Vec3& normal, Directions& directions) {
  Vec3 gone = allowed(directions, normal);
  if (gone.norm() <= same_plane) return;
  gone.normalize();
  if (directions.size() == 3) {
    const Vec3 first = gone.unitOrthogonal();
    directions = {first, gone.cross(first)};
  } else if (directions.size() == 2) {
    directions = {directions[0].cross(directions[1]).cross(gone).normalized()};
  } else {
    directions.clear();
  }
}

}  // namespace

Vec3 allowed(const Directions& directions, const Vec3& move) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& direction : directions) sum += direction.dot(move) * direction;
  return sum;
}

Freedom full_freedom(std::size_t vertex_count) {
  return Freedom(vertex_count, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
}

void keep_planes_beside_tags(const PolyMesh& mesh, const MeshTopology& topology, Freedom& freedom) {
  const std::vector<double> sharpness = edge_sharpness(mesh.tags, topology);
  for (Index face = 0; face < mesh.face_count(); ++face) {
    bool beside = false;
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
      beside = beside || sharpness[topology.edge(corner)] > 0;
    }
    if (!beside || relative_deviation(mesh, face) > planar_tolerance) continue;
    const Vec3 normal = area_normal(mesh, face);
    if (normal.norm() == 0) continue;
    for (const Index vertex : mesh.face(face)) remove_direction(normal.normalized(), freedom[vertex]);
  }
}

void hold(const PolyMesh& mesh, const MeshTopology& topology, bool hold_tags, Freedom& freedom) {
  const std::vector<double> sharpness = edge_sharpness(mesh.tags, topology);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const bool boundary = topology.edge_corners(edge).size() == 1;
    if (!boundary && !(hold_tags && sharpness[edge] > 0)) continue;
    for (const Index vertex : topology.edge_vertices(edge)) freedom[vertex].clear();
  }
  for (const Index pin : mesh.tags.pins) {
    if (pin < freedom.size()) freedom[pin].clear();
  }
  for (Index vertex = 0; vertex < freedom.size(); ++vertex) {
    if (topology.vertex_corners(vertex).empty()) freedom[vertex].clear();
  }
}

Eigen::SparseMatrix<double> freedom_matrix(const Freedom& freedom) {
  std::vector<Eigen::Triplet<double>> entries;
  int column = 0;
  for (std::size_t v = 0; v < freedom.size(); ++v) {
    for (const Vec3& direction : freedom[v]) {
      for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] != 0) entries.emplace_back(static_cast<int>(3 * v) + axis, column, direction[axis]);
      }
      ++column;
    }
  }
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(3 * freedom.size()), column);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace croquis::subdivision
