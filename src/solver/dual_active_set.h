// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace croquis {

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

}  // namespace croquis
