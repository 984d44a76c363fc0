// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace croquis::implicit {

/// A = L L' in place, for a symmetric positive definite matrix of which the lower triangle is read and overwritten,
/// nothing else.
///
/// Blocked and right-looking, in an order of operations that depends on the size alone: the same bits on every machine,
/// which a library that fits its blocks to the caches doesn't guarantee. n^3/3 multiplications and additions.
/// @param a      column-major
/// @param stride between columns, >= n
/// @param least  a pivot not larger than this ends the factorisation
/// @return false then; the matrix is overwritten
bool factor_cholesky(double* a, std::size_t n, std::size_t stride, double least);

/// Solves L L' x = b in place, with the factor of factor_cholesky.
void solve_cholesky(const double* a, std::size_t n, std::size_t stride, double* b);

/// Weights w and coefficients p with  A w + Q p = h,  Q' w = 0  (Yoo 2005, eq. 6).
struct ConstrainedWeights {
  Eigen::VectorXd weights;       ///< #n
  Eigen::VectorXd coefficients;  ///< #k; the shortest where Q lacks rank
  int rank = 0;                  ///< of Q
  bool rank_revealing = false;   ///< A was not positive definite there; a complete orthogonal decomposition solved it
};

/// Solves it for an A that is positive definite on the null space of Q', without pivoting: with Q = H R, H orthogonal,
/// the last n - rank rows and columns of H'AH are positive definite.
///
/// n^3/3 multiplications; where that breaks down, the whole system by a rank-revealing method, about ten times as slow.
/// @param a n by n, symmetric, both triangles; overwritten
/// @param q n by k, k small, n >= 1
ConstrainedWeights solve_constrained(Eigen::MatrixXd& a, const Eigen::MatrixXd& q, const Eigen::VectorXd& h);

}  // namespace croquis::implicit
