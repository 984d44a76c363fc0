// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scaled_problem.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

using Eigen::VectorXd;

VectorXd column_lengths(const Eigen::SparseMatrix<double>& matrix) {
  VectorXd lengths = VectorXd::Zero(matrix.cols());
  if (matrix.rows() == 0) return lengths;  // Eigen sums no column without rows
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) lengths[j] = matrix.col(j).norm();
  return lengths;
}

double inverse_or_one(double length) { return length > 0 ? 1 / length : 1; }

/// An unknown that isn't in the objective has no unit of its own: it takes that of the rows it shares with others.
void raise_by_rows(const RowMatrix& rows, const VectorXd& objective_lengths, VectorXd& lengths) {
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    double known = 0;
    for (RowMatrix::InnerIterator entry(rows, row); entry; ++entry) {
      const double length = objective_lengths[entry.col()];
      if (length > 0) known = std::max(known, std::abs(entry.value()) / length);
    }
    const double unit = inverse_or_one(known);
    for (RowMatrix::InnerIterator entry(rows, row); entry; ++entry) {
      if (objective_lengths[entry.col()] > 0) continue;
      double& length = lengths[entry.col()];
      length = std::max(length, std::abs(entry.value()) * unit);
    }
  }
}

/// Scales the columns, then each row to length 1; returns the rows' factors.
VectorXd scale_rows(RowMatrix& rows, const VectorXd& column_scale) {
  if (rows.rows() == 0) {  // a default-made matrix has no columns either, and Eigen multiplies only what fits
    rows.resize(0, column_scale.size());
    return {};
  }
  rows = rows * column_scale.asDiagonal();
  VectorXd factors(rows.rows());
  for (Eigen::Index row = 0; row < rows.rows(); ++row) factors[row] = inverse_or_one(rows.row(row).norm());
  rows = factors.asDiagonal() * rows;
  return factors;
}

}  // namespace

ScaledProblem scale(const LeastSquaresProblem& problem) {
  ScaledProblem scaled;
  scaled.equalities = problem.equalities;
  scaled.inequalities = problem.inequalities;

  const VectorXd objective_lengths = column_lengths(problem.objective);
  VectorXd lengths = objective_lengths;
  raise_by_rows(scaled.equalities, objective_lengths, lengths);
  raise_by_rows(scaled.inequalities, objective_lengths, lengths);
  scaled.column_scale = lengths.unaryExpr(&inverse_or_one);

  scaled.objective = problem.objective * scaled.column_scale.asDiagonal();
  scaled.equality_scale = scale_rows(scaled.equalities, scaled.column_scale);
  scaled.inequality_scale = scale_rows(scaled.inequalities, scaled.column_scale);
  return scaled;
}

}  // namespace croquis
