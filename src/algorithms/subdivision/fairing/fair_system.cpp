// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/fairing/fair_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "algorithms/subdivision/levels/level_geometry.h"
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

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Slivers with a smaller share of area than this would outweigh everything else.
constexpr double least_corner_sine = 1e-6;

double cotangent(const Vec3& a, const Vec3& b) {
  const double area = a.cross(b).norm();
  const double least = least_corner_sine * a.norm() * b.norm();
  return least > 0 ? a.dot(b) / std::max(area, least) : 0;
}

/// The vertices and, behind them, the faces' centres.
WeightMatrix with_centres(const HalfEdges& mesh) {
  WeightRows rows;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    rows.add(v, 1);
    rows.end_row();
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) rows.add(v, 1 / static_cast<double>(mesh.face(f).size()));
    rows.end_row();
  }
  return to_matrix(rows, mesh.vertex_count());
}

/// The cotangents of triangle (a, b, c) for its three edges.
void add_triangle(const std::array<Index, 3>& triangle, const std::array<Vec3, 3>& points, Triplets& entries) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double weight = cotangent(points[j] - points[i], points[k] - points[i]) / 2;
    const auto a = static_cast<int>(triangle[j]), b = static_cast<int>(triangle[k]);
    entries.emplace_back(a, b, weight);
    entries.emplace_back(b, a, weight);
    entries.emplace_back(a, a, -weight);
    entries.emplace_back(b, b, -weight);
  }
}

/// Of the faces cut into triangles from their centres.
WeightMatrix triangle_laplacian(const HalfEdges& mesh, std::span<const Vec3> positions, const WeightMatrix& centres) {
  Triplets entries;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vec3 centre = Vec3::Zero();
    for (const Index v : face) centre += positions[v];
    centre /= static_cast<double>(face.size());
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      add_triangle({static_cast<Index>(mesh.vertex_count() + f), a, b}, {centre, positions[a], positions[b]}, entries);
    }
  }
  WeightMatrix laplacian(centres.rows(), centres.rows());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

std::vector<double> vertex_areas(const HalfEdges& mesh, std::span<const Vec3> positions) {
  std::vector<double> areas(mesh.vertex_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const double share = area_normal(positions, mesh.face(f)).norm() / static_cast<double>(face.size());
    for (const Index v : face) areas[v] += share;
  }
  return areas;
}

/// 1 / root of the area, or 0 for vertices whose row is left out.
std::vector<double> row_factors(const Level& level, std::span<const Vec3> positions) {
  const HalfEdges& mesh = level.topology;
  std::vector<double> factors = vertex_areas(mesh, positions);
  for (double& factor : factors) factor = factor > 0 ? 1 / std::sqrt(factor) : 0;
  for (const Index corner : level.boundary) {
    factors[mesh.corner_vertex[corner]] = 0;
  }
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = mesh.edge_corner[sharp.edge];
    factors[mesh.corner_vertex[corner]] = 0;
    factors[mesh.corner_vertex[mesh.twin[corner]]] = 0;
  }
  for (const Index pin : level.pins) factors[pin] = 0;
  return factors;
}

using Matrix = Eigen::SparseMatrix<double>;

/// Second differences at every vertex of a closed chain, at the inner ones of an open one.
Matrix second_differences(std::size_t count, bool closed) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(count);
  const int first = closed ? 0 : 1, last = closed ? n - 1 : n - 2;
  for (int i = first; i <= last; ++i) {
    entries.emplace_back(i - first, (i + n - 1) % n, 1);
    entries.emplace_back(i - first, i, -2);
    entries.emplace_back(i - first, (i + 1) % n, 1);
  }
  Matrix matrix(last - first + 1, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Where an open chain's ends are held, its unknowns are the vertices between.
Matrix free_columns(std::size_t count, bool closed) {
  const auto n = static_cast<int>(count);
  const int offset = closed ? 0 : 1;
  Matrix matrix(n, n - 2 * offset);
  for (int i = 0; i < n - 2 * offset; ++i) matrix.insert(i + offset, i) = 1;
  return matrix;
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
    if (!beside || !is_planar(mesh, face)) continue;
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

WeightMatrix fair_laplacian(const Level& level, std::span<const Vec3> positions) {
  const WeightMatrix centres = with_centres(level.topology);
  const WeightMatrix by_triangles = triangle_laplacian(level.topology, positions, centres);
  const WeightMatrix half = by_triangles * centres;
  const WeightMatrix gather = centres.transpose();
  WeightMatrix laplacian = gather * half;
  const std::vector<double> factors = row_factors(level, positions);
  for (Eigen::Index row = 0; row < laplacian.outerSize(); ++row) {
    for (WeightMatrix::InnerIterator entry(laplacian, row); entry; ++entry) {
      entry.valueRef() *= factors[static_cast<std::size_t>(row)];
    }
  }
  laplacian.prune(0.0);
  return laplacian;
}

std::vector<Vec3> fair_chain(const EdgeChain& chain, const ChainShape& shape, std::vector<Vec3> points,
                             double edge_length, double weight) {
  if (points.size() < 3) return points;
  const Matrix differences = second_differences(points.size(), chain.closed);
  const Matrix free = free_columns(points.size(), chain.closed);
  Eigen::MatrixX3d start(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) start.row(static_cast<Eigen::Index>(i)) = points[i].transpose();

  const Matrix reduced = differences * free;
  Matrix system = reduced.transpose() * reduced;
  system *= 1 / (edge_length * edge_length);
  Matrix identity(system.rows(), system.cols());
  identity.setIdentity();
  system += weight * identity;
  const Eigen::MatrixX3d bent = differences * start;
  const Eigen::MatrixX3d right = reduced.transpose() * bent * (-1 / (edge_length * edge_length));
  const Eigen::SimplicialLDLT<Matrix> factor(system);
  const Eigen::MatrixX3d moves = free * factor.solve(right).eval();
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3 move = moves.row(static_cast<Eigen::Index>(i)).transpose();
    if (shape.planar()) move -= move.dot(shape.plane_normal) * shape.plane_normal;
    points[i] += move;
  }
  return points;
}

}  // namespace croquis::subdivision
