// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "croquis/base/progress.h"
#include "solver/elastic_optimum.h"
#include "solver/kkt_system.h"

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

/// The multipliers of a few rows G y >= b, by the dual active-set method of Goldfarb and Idnani (1983), with all of the
/// unknowns eliminated: what is left of the problem is the rows' flexibility S = G K^-1 G^T, which is how far a unit
/// of force along one row moves another.
///
/// Rows are added between the calls of solve(), which starts from the last active set. Dense: O(#active^2) per change.
class DualActiveSet {
 public:
  enum class Outcome {
    Solved,
    Contradictory,  ///< no multipliers, however large, hold all rows
    GaveUp          ///< too many changes
  };

  Eigen::Index size() const { return multipliers_.size(); }
  std::size_t active_count() const { return active_.size(); }

  /// @param flexibility S between the new row and every row so far, then with itself
  void add_row(const Eigen::VectorXd& flexibility);

  /// Finds multipliers >= 0 such that no row is violated and every row with a multiplier is met exactly. Rows that
  /// depend on those with a multiplier can't be improved by any force: they may stay violated a
  /// little, for the caller to see.
  ///
  /// @param violation b - G y of every row, at the present multipliers; changed to what is left, 0 up to `tolerance`
  Outcome solve(Eigen::VectorXd& violation, double tolerance);

  const Eigen::VectorXd& multipliers() const { return multipliers_; }

 private:
  struct Answer;

  Outcome settle(Eigen::VectorXd& violation);
  Outcome satisfy(Eigen::Index row, Eigen::VectorXd& violation);
  Answer answer_to(Eigen::Index row) const;
  void push(const Eigen::VectorXd& change, double length, Eigen::VectorXd& violation);
  void activate(Eigen::Index row);
  void release(std::size_t place);
  Eigen::Index most_violated(const Eigen::VectorXd& violation, double tolerance) const;
  Eigen::VectorXd active_part(const Eigen::VectorXd& values) const;

  Eigen::MatrixXd flexibility_;       ///< S, room for more rows than there are
  Eigen::VectorXd multipliers_;       ///< per row
  std::vector<Eigen::Index> active_;  ///< rows with a multiplier, as they came
  std::vector<char> is_active_;       ///< per row
  std::vector<char> is_implied_;      ///< per row: met as well as can be, through the rows that it depends on
  Eigen::MatrixXd factor_;            ///< lower Cholesky factor of S between the active rows
  int changes_left_ = 0;
};

/// Looks for the optimum among those where every row holds, through the few rows that press there.
///
/// In rounds: the rows violated most join those known, their multipliers are found by a dual active-set method on the
/// known rows alone, and one solve with the factors of K(0) moves the unknowns and refines them. No factorisation, and
/// rows that nothing comes near cost nothing. Ends where the optimality conditions hold up to rounding.
///
/// @param system holds the factors of K(0)
/// @param point set to the optimum, its penalty large enough for its multipliers; untouched when there is none
/// @return Contradictory when no forces hold all rows, GaveUp when more of them press than this method is meant for
DualActiveSet::Outcome find_active_rows(const ElasticProblem& problem, const KktSystem& system, ElasticPoint& point,
                                        Progress& progress);

}  // namespace croquis
