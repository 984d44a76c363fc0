// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace croquis::implicit {

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
