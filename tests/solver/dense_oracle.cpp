// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/dense_oracle.h"

#include <cmath>
#include <vector>

#include <Eigen/QR>

namespace croquis::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_squares_on(const MatrixXd& matrix, const VectorXd& right_side, const std::vector<Index>& columns) {
  MatrixXd chosen(matrix.rows(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) chosen.col(static_cast<Index>(k)) = matrix.col(columns[k]);
  const VectorXd part = chosen.completeOrthogonalDecomposition().solve(right_side);
  VectorXd whole = VectorXd::Zero(matrix.cols());
  for (std::size_t k = 0; k < columns.size(); ++k) whole[columns[k]] = part[static_cast<Index>(k)];
  return whole;
}

std::vector<Index> positive_entries(const std::vector<bool>& positive) {
  std::vector<Index> columns;
  for (std::size_t k = 0; k < positive.size(); ++k)
    if (positive[k]) columns.push_back(static_cast<Index>(k));
  return columns;
}

/// min |A u - b| with u >= 0, Lawson and Hanson's active set method.
VectorXd non_negative_least_squares(const MatrixXd& a, const VectorXd& b) {
  VectorXd u = VectorXd::Zero(a.cols());
  std::vector<bool> positive(static_cast<std::size_t>(a.cols()), false);
  for (int outer = 0; outer < 10 * static_cast<int>(a.cols()) + 10; ++outer) {
    const VectorXd slope = a.transpose() * (b - a * u);
    Index best = -1;
    for (Index k = 0; k < u.size(); ++k)
      if (!positive[static_cast<std::size_t>(k)] && slope[k] > 1e-13 && (best < 0 || slope[k] > slope[best])) best = k;
    if (best < 0) break;
    positive[static_cast<std::size_t>(best)] = true;
    while (true) {
      const VectorXd wanted = least_squares_on(a, b, positive_entries(positive));
      double step = 1;
      for (const Index k : positive_entries(positive))
        if (wanted[k] <= 0) step = std::min(step, u[k] / (u[k] - wanted[k]));
      if (step == 1) {
        u = wanted;
        break;
      }
      if (!std::isfinite(step)) step = 0;
      u += step * (wanted - u);
      for (const Index k : positive_entries(positive))
        if (wanted[k] <= 0 && u[k] <= 1e-14) {
          u[k] = 0;
          positive[static_cast<std::size_t>(k)] = false;
        }
    }
  }
  return u;
}

/// min |z| with G z >= h; none when there is no such z.
std::optional<VectorXd> least_distance(const MatrixXd& g, const VectorXd& h) {
  MatrixXd a(g.cols() + 1, g.rows());
  a << g.transpose(), h.transpose();
  VectorXd b = VectorXd::Zero(g.cols() + 1);
  b[g.cols()] = 1;
  const VectorXd residual = a * non_negative_least_squares(a, b) - b;
  if (residual.norm() < 1e-9) return std::nullopt;
  return VectorXd(-residual.head(g.cols()) / residual[g.cols()]);
}

}  // namespace

std::optional<VectorXd> dense_optimum(const LeastSquaresProblem& problem) {
  const MatrixXd e = problem.equalities;
  const Index unknowns = problem.objective.cols();
  VectorXd particular = VectorXd::Zero(unknowns);
  MatrixXd free = MatrixXd::Identity(unknowns, unknowns);
  if (e.rows() > 0) {
    particular = e.completeOrthogonalDecomposition().solve(problem.equality_values);
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(e.transpose());
    free = MatrixXd(qr.householderQ()).rightCols(unknowns - qr.rank());
  }
  if (free.cols() == 0) return particular;
  const MatrixXd u = problem.objective * free;
  const Eigen::HouseholderQR<MatrixXd> qr(u);
  const MatrixXd r = qr.matrixQR().topRows(u.cols()).triangularView<Eigen::Upper>();
  const VectorXd t = problem.target - problem.objective * particular;
  const VectorXd start = (qr.householderQ().transpose() * t).head(u.cols());
  VectorXd z = VectorXd::Zero(u.cols());
  if (problem.inequalities.rows() > 0) {
    // With z = R v - start the objective is |z|^2.
    const MatrixXd g = problem.inequalities * free;
    const MatrixXd rows = r.transpose().triangularView<Eigen::Lower>().solve(MatrixXd(g.transpose())).transpose();
    const VectorXd bounds = problem.inequality_bounds - problem.inequalities * particular - rows * start;
    const std::optional<VectorXd> nearest = least_distance(rows, bounds);
    if (!nearest) return std::nullopt;
    z = *nearest;
  }
  return VectorXd(particular + free * r.triangularView<Eigen::Upper>().solve(z + start));
}

}  // namespace croquis::test
