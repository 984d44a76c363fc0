// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/fairing/fair_laplacian.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

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

}  // namespace

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

}  // namespace croquis::subdivision
