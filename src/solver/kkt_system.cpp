// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/kkt_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

/// Refinement has reached what rounding allows when a round gains less than this.
constexpr double worthwhile_gain = 0.5;
/// A residual this small, relative to the right side, needs no refinement.
constexpr double good_residual = 1e-12;

/// The lower triangle of U^T U, column by column.
Matrix lower_hessian(const Matrix& objective) {
  const RowMatrix rows = objective;
  Matrix hessian(objective.cols(), objective.cols());
  VectorXd sums = VectorXd::Zero(objective.cols());
  std::vector<int> met;
  std::vector<char> is_met(static_cast<std::size_t>(objective.cols()), 0);
  hessian.reserve(2 * objective.nonZeros());
  for (Eigen::Index column = 0; column < objective.cols(); ++column) {
    met.clear();
    for (Matrix::InnerIterator down(objective, column); down; ++down) {
      for (RowMatrix::InnerIterator along(rows, down.row()); along; ++along) {
        if (along.col() < column) continue;
        if (is_met[static_cast<std::size_t>(along.col())] == 0) met.push_back(static_cast<int>(along.col()));
        is_met[static_cast<std::size_t>(along.col())] = 1;
        sums[along.col()] += down.value() * along.value();
      }
    }
    std::sort(met.begin(), met.end());
    hessian.startVec(column);
    for (const int row : met) {
      hessian.insertBack(row, column) = sums[row];
      sums[row] = 0;
      is_met[static_cast<std::size_t>(row)] = 0;
    }
  }
  hessian.finalize();
  return hessian;
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

KktSystem::KktSystem(const ScaledProblem& problem, Rows rows) : problem_(&problem), rows_(rows) {
  fill_constant_part(lower_hessian(problem.objective));
  map_inequalities();
  if (size() > 0) factors_.analyzePattern(matrix_);
}

/// With a place, 0, for every number that row weights can change.
void KktSystem::fill_constant_part(Matrix hessian) {
  const Eigen::Index unknowns = problem_->objective.cols();
  const Eigen::Index equalities = problem_->equalities.rows();
  std::vector<Triplet> entries;
  const auto add = [&entries](Eigen::Index row, Eigen::Index column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (Eigen::Index i = 0; i < unknowns + equalities; ++i)
    add(i, i, i < unknowns ? regularisation : -equality_regularisation);
  for (Eigen::Index row = 0; row < equalities; ++row)
    for (RowMatrix::InnerIterator entry(problem_->equalities, row); entry; ++entry)
      add(unknowns + row, entry.col(), entry.value());
  const Eigen::Index weighted = rows_ == Rows::Weighted ? problem_->inequalities.rows() : 0;
  for (Eigen::Index row = 0; row < weighted; ++row)
    for (RowMatrix::InnerIterator a(problem_->inequalities, row); a; ++a)
      for (RowMatrix::InnerIterator b(problem_->inequalities, row); b && b.col() <= a.col(); ++b)
        add(a.col(), b.col(), 0);
  Matrix rest(unknowns + equalities, unknowns + equalities);
  rest.setFromTriplets(entries.begin(), entries.end());
  hessian.conservativeResize(unknowns + equalities, unknowns + equalities);
  matrix_ = hessian + rest;
  constant_part_ = Eigen::Map<const VectorXd>(matrix_.valuePtr(), matrix_.nonZeros());
}

int KktSystem::position_of(Eigen::Index row, Eigen::Index column) const {
  const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
  const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
  const int* found = std::lower_bound(begin, end, static_cast<int>(row));
  return found != end && *found == row ? static_cast<int>(found - matrix_.innerIndexPtr()) : -1;
}

void KktSystem::map_inequalities() {
  contributions_.clear();
  contribution_begin_.assign(1, 0);
  if (rows_ == Rows::None) return;
  for (Eigen::Index row = 0; row < problem_->inequalities.rows(); ++row) {
    for (RowMatrix::InnerIterator a(problem_->inequalities, row); a; ++a)
      for (RowMatrix::InnerIterator b(problem_->inequalities, row); b && b.col() <= a.col(); ++b)
        contributions_.push_back({position_of(a.col(), b.col()), a.value() * b.value()});
    contribution_begin_.push_back(contributions_.size());
  }
}

bool KktSystem::factorise(const VectorXd& row_weights) {
  if (size() == 0) return true;
  Eigen::Map<VectorXd> values(matrix_.valuePtr(), matrix_.nonZeros());
  values = constant_part_;
  for (Eigen::Index row = 0; row < row_weights.size(); ++row) {
    const auto q = static_cast<std::size_t>(row);
    for (std::size_t k = contribution_begin_[q]; k < contribution_begin_[q + 1]; ++k)
      values[contributions_[k].position] += row_weights[row] * contributions_[k].product;
  }
  factors_.factorize(matrix_);
  ++factorisations_;
  return factors_.info() == Eigen::Success;
}

VectorXd KktSystem::multiply(const VectorXd& vector) const {
  VectorXd product = matrix_.selfadjointView<Eigen::Lower>() * vector;
  product.head(unknowns()) -= regularisation * vector.head(unknowns());
  product.tail(size() - unknowns()) += equality_regularisation * vector.tail(size() - unknowns());
  return product;
}

VectorXd KktSystem::solve(const VectorXd& right_side, int refinements) const {
  VectorXd solution = factors_.solve(right_side);
  if (refinements == 0) return solution;
  VectorXd residual = right_side - multiply(solution);
  const double good = good_residual * right_side.lpNorm<Eigen::Infinity>();
  for (int round = 0; round < refinements; ++round) {
    const double before = residual.lpNorm<Eigen::Infinity>();
    if (before <= good) break;
    VectorXd better = solution + factors_.solve(residual);
    VectorXd better_residual = right_side - multiply(better);
    const double after = better_residual.lpNorm<Eigen::Infinity>();
    if (!(after < before)) break;
    solution = std::move(better);
    residual = std::move(better_residual);
    if (after > worthwhile_gain * before) break;
  }
  return solution;
}

}  // namespace croquis
