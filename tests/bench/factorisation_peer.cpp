// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/factorisation_peer.h"

#include <vector>

#include <Eigen/SparseCholesky>

#include "bench/cpu_time.h"

namespace croquis::bench {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// The lower triangle of [[U^T U + G^T G + dI, E^T], [E, -dI]]: what every step of the solver factorises, built by
/// plain sparse products.
Matrix step_matrix(const LeastSquaresProblem& problem) {
  const Matrix hessian = Matrix(problem.objective.transpose() * problem.objective) +
                         Matrix(problem.inequalities.transpose() * problem.inequalities);
  const int unknowns = static_cast<int>(hessian.cols());
  const int size = unknowns + static_cast<int>(problem.equalities.rows());
  const double regularisation = 1e-10 * hessian.diagonal().maxCoeff();
  Triplets entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i < unknowns ? regularisation : -regularisation);
  for (int column = 0; column < unknowns; ++column) {
    for (Matrix::InnerIterator entry(hessian, column); entry; ++entry)
      if (entry.row() >= column) entries.emplace_back(static_cast<int>(entry.row()), column, entry.value());
    if (problem.equalities.rows() == 0) continue;
    for (Matrix::InnerIterator entry(problem.equalities, column); entry; ++entry)
      entries.emplace_back(unknowns + static_cast<int>(entry.row()), column, entry.value());
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

double factorisation_ms(const LeastSquaresProblem& problem) {
  const Matrix matrix = step_matrix(problem);
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> factors;
  factors.analyzePattern(matrix);
  return median_cpu_ms(9, [&] { factors.factorize(matrix); });
}

}  // namespace croquis::bench
