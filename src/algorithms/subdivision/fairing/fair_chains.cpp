// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/fairing/fair_chains.h"

#include <cmath>
#include <utility>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace croquis::subdivision {
namespace {

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
