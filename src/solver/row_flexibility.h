// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "solver/kkt_system.h"
#include "solver/scaled_problem.h"

namespace croquis {

/// The entries of S = G K^-1 G^T for the inequalities that are asked for, one after the other.
///
/// With P K P^T = L D L^T, S is the product u^T D^-1 v of the rows' half solutions u = L^-1 P g. Those are sparse: one
/// elimination step per unknown on the paths from the row's unknowns to the root of the elimination tree (Liu 1990),
/// a small part of a whole solve.
class RowFlexibility {
 public:
  /// Keeps references; `system` must hold the factors of K(0).
  RowFlexibility(const ScaledProblem& problem, const KktSystem& system);

  /// S between inequality `row` and every one asked for so far, then with itself.
  Eigen::VectorXd add(Eigen::Index row);

 private:
  struct HalfSolution {
    std::vector<int> places;  ///< ascending
    Eigen::VectorXd values;
  };

  HalfSolution half_solve(Eigen::Index row);
  std::vector<int> start(Eigen::Index row);
  std::vector<int> reached(std::vector<int> start) const;

  const ScaledProblem& problem_;
  const KktSystem& system_;
  std::vector<HalfSolution> halves_;
  Eigen::VectorXd work_;  ///< 0 between the calls
};

}  // namespace croquis
