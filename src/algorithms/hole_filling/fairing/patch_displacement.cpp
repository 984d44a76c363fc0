// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/patch_displacement.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

namespace croquis::hole_filling {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Of a place that is to be met, beside 1 for every vertex' bending.
constexpr double pin_weight = 1e6;
constexpr double pull_spacing_growth = 1.3;

/// Rows for all vertices of the patch, columns for the new ones: the others don't move.
Sparse umbrella_laplacian(const HolePatch& patch, Index given) {
  std::vector<std::pair<Index, Index>> edges;  // in both directions
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.emplace_back(t[i], t[(i + 1) % 3]);
      edges.emplace_back(t[(i + 1) % 3], t[i]);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Eigen::Triplet<double>> entries;
  int row = -1;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].first == edges[i].first) ++end;
    ++row;
    const double share = 1 / static_cast<double>(end - i);
    if (edges[i].first >= given) entries.emplace_back(row, static_cast<int>(edges[i].first - given), 1.0);
    for (; i < end; ++i) {
      if (edges[i].second >= given) entries.emplace_back(row, static_cast<int>(edges[i].second - given), -share);
    }
  }
  Sparse laplacian(row + 1, static_cast<Eigen::Index>(patch.points.size()));
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/// Per place another new vertex, the nearest that is left.
std::vector<std::size_t> nearest_points(const std::vector<Vec3>& points, std::span<const Vec3> places) {
  std::vector<std::size_t> chosen;
  for (const Vec3& place : places) {
    std::size_t best = points.size();
    for (std::size_t v = 0; v < points.size(); ++v) {
      if ((best == points.size() || (points[v] - place).norm() < (points[best] - place).norm()) &&
          std::find(chosen.begin(), chosen.end(), v) == chosen.end())
        best = v;
    }
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace

bool displace_through(const PolyMesh& mesh, HolePatch& patch, std::span<const Vec3> places) {
  if (patch.points.size() < places.size()) return false;
  const Sparse laplacian = umbrella_laplacian(patch, static_cast<Index>(mesh.vertex_count()));
  const std::vector<std::size_t> pins = nearest_points(patch.points, places);
  Sparse matrix = laplacian.transpose() * laplacian;
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(matrix.rows(), 3);
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(pins[i]);
    matrix.coeffRef(at, at) += pin_weight;
    wanted.row(at) = pin_weight * (places[i] - patch.points[pins[i]]).transpose();
  }
  const Eigen::SimplicialLDLT<Sparse> solver(matrix);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::MatrixXd moves = solver.solve(wanted);
  if (!moves.allFinite()) return false;
  for (std::size_t v = 0; v < patch.points.size(); ++v)
    patch.points[v] += moves.row(static_cast<Eigen::Index>(v)).transpose();
  return true;
}

std::vector<PassingPoint> spread_points(const PolyMesh& mesh, const HolePatch& patch, double spacing,
                                        std::size_t most) {
  const auto given = static_cast<Index>(mesh.vertex_count());
  const auto at = [&](Index v) { return v < given ? mesh.positions[v] : patch.points[v - given]; };
  std::vector<Vec3> normals(patch.points.size(), Vec3::Zero());
  for (const auto& [a, b, c] : patch.triangles) {
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    for (const Index v : {a, b, c}) {
      if (v >= given) normals[v - given] += normal;
    }
  }
  for (;; spacing *= pull_spacing_growth) {
    std::vector<PassingPoint> taken;
    for (std::size_t v = 0; v < patch.points.size() && taken.size() <= most; ++v) {
      const double length = normals[v].norm();
      const bool is_free = std::all_of(taken.begin(), taken.end(), [&](const PassingPoint& other) {
        return (other.position - patch.points[v]).squaredNorm() >= spacing * spacing;
      });
      if (length > 0 && is_free) taken.push_back({patch.points[v], normals[v] / length});
    }
    if (taken.size() <= most) return taken;
  }
}

}  // namespace croquis::hole_filling
