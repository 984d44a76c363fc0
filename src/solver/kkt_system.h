// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/solver/least_squares.h"
#include "croquis/solver/symmetric_factors.h"

namespace croquis {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The problem's matrices free of units: x = column_scale * y, and each row of E and G divided by its length.
///
/// Lengths and gradients side by side, and drawings in any unit, so give the same numbers up to rounding.
struct ScaledProblem {
  Eigen::SparseMatrix<double> objective;  ///< #R by N, columns of length 1 (or empty)
  RowMatrix equalities;                   ///< #E by N, rows of length 1 (or empty)
  RowMatrix inequalities;                 ///< #I by N, rows of length 1 (or empty)
  Eigen::VectorXd column_scale;           ///< N, > 0
  Eigen::VectorXd equality_scale;         ///< #E, > 0: scaled row = factor * row
  Eigen::VectorXd inequality_scale;       ///< #I, > 0
};

/// @param problem checked and complete (see problem_check.h)
ScaledProblem scale(const LeastSquaresProblem& problem);

/// Relative to the rows' and variables' own scales: what an accepted solution may miss a condition by.
inline constexpr double verification_tolerance = 1e-10;
/// Rounds of iterative refinement after one factorisation.
inline constexpr int most_refinements = 12;

/// The matrix K(D) = [[H + G^T D G, E^T], [E, 0]] with H = U^T U, D diagonal and >= 0, whose pattern never changes.
///
/// What is factorised is K plus diag(d, -e), d = `regularisation` and e = `equality_regularisation`: quasi-definite, so
/// that L D L^T exists for every elimination order (Vanderbei 1995), also with dependent equalities or an objective
/// without curvature. Iterative refinement against K itself takes them out of the solution.
class KktSystem {
 public:
  /// Relative to the largest diagonal entry of H, which the scaling makes 1. Large against rounding (1e-16 times the
  /// growth of a factor), small against the curvatures met: 1e-8 for a plate of 30 000 vertices, 1e-11 for a thin one
  /// among wide ones, which its pulls hold that much softer than it bends. Above the curvature of a direction,
  /// refinement would move along it by a small part of the distance per round.
  static constexpr double regularisation = 1e-13;

  /// The same for equalities: large against the rounding of what is left of dependent ones.
  static constexpr double equality_regularisation = 1e-10;

  /// Which D the matrix is for: without rows the factors are sparser.
  enum class Rows { None, Weighted };

  /// Builds the pattern and where each number goes in it, and analyses it: once. Keeps a reference to `problem`.
  KktSystem(const ScaledProblem& problem, Rows rows);

  /// Numeric factorisation for the row weights D (#I, >= 0; none: D = 0); false when rounding left a pivot 0.
  [[nodiscard]] bool factorise(const Eigen::VectorXd& row_weights);

  /// Solves K(D) solution = right_side (N + #E), refined until the residual stops shrinking, at most `refinements`
  /// times.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side, int refinements) const;

  /// One back substitution with the regularised factors.
  Eigen::VectorXd solve_regularised(const Eigen::VectorXd& right_side) const { return factors_.solve(right_side); }

  Eigen::VectorXd multiply(const Eigen::VectorXd& vector) const;

  const SymmetricFactors& factors() const { return factors_; }

  int factorisations() const { return factorisations_; }
  Eigen::Index unknowns() const { return problem_->objective.cols(); }
  Eigen::Index size() const { return matrix_.cols(); }

 private:
  /// Position in the matrix' values, and the product of two entries of an inequality row that D's entry multiplies.
  struct Contribution {
    int position;
    double product;
  };

  void fill_constant_part(Eigen::SparseMatrix<double> hessian);
  void map_inequalities();
  int position_of(Eigen::Index row, Eigen::Index column) const;

  const ScaledProblem* problem_;
  Rows rows_;
  Eigen::SparseMatrix<double> matrix_;       ///< lower triangle, regularised
  Eigen::VectorXd constant_part_;            ///< its values for D = 0
  std::vector<Contribution> contributions_;  ///< of row q: from contribution_begin_[q] to [q + 1]
  std::vector<std::size_t> contribution_begin_;
  SymmetricFactors factors_;
  int factorisations_ = 0;
};

}  // namespace croquis
