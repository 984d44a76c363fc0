// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/dual_active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace croquis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A row that keeps less than this part of its flexibility once the active rows are held depends on them.
constexpr double dependence = 1e-10;
/// The same, where an unknown's own flexibility is 1: less than this is left to rows that depend on equalities, by the
/// equalities' regularisation of 1e-10 times the square of their coefficients.
constexpr double least_flexibility = 1e-7;
/// Changes of the active set, per row: few rows come and go more than once.
constexpr int changes_per_row = 4;
/// Violation that a row depending on the active ones may keep: what the regularisation makes of rows that hold, which
/// the caller's refinement takes out again.
constexpr double implied_violation = 1e-5;

/// At least `size` by `size`, the old entries kept; doubled, so that growing row by row stays cheap.
void make_room(MatrixXd& matrix, Eigen::Index size) {
  if (matrix.rows() >= size) return;
  const Eigen::Index room = std::max<Eigen::Index>(16, 2 * size);
  matrix.conservativeResize(room, room);
}

}  // namespace

/// How the active rows' multipliers change with a unit of force along another row.
struct DualActiveSet::Answer {
  VectorXd half;           ///< L^-1 S_Pq
  VectorXd relief;         ///< S_PP^-1 S_Pq: what each active row loses
  double flexibility = 0;  ///< how far the row still moves; 0 when it depends on the active ones
};

void DualActiveSet::add_row(const VectorXd& flexibility) {
  const Eigen::Index row = size();
  make_room(flexibility_, row + 1);
  flexibility_.row(row).head(row + 1) = flexibility.transpose();
  flexibility_.col(row).head(row + 1) = flexibility;
  multipliers_.conservativeResize(row + 1);
  multipliers_[row] = 0;
  is_active_.push_back(0);
  is_implied_.push_back(0);
}

VectorXd DualActiveSet::active_part(const VectorXd& values) const {
  VectorXd part(static_cast<Eigen::Index>(active_.size()));
  for (std::size_t i = 0; i < active_.size(); ++i) part[static_cast<Eigen::Index>(i)] = values[active_[i]];
  return part;
}

DualActiveSet::Answer DualActiveSet::answer_to(Eigen::Index row) const {
  const auto count = static_cast<Eigen::Index>(active_.size());
  const auto factor = factor_.topLeftCorner(count, count).triangularView<Eigen::Lower>();
  Answer answer;
  answer.half = factor.solve(active_part(flexibility_.col(row)));
  answer.relief = factor.transpose().solve(answer.half);
  const double own = flexibility_(row, row);
  const double left = own - answer.half.squaredNorm();
  answer.flexibility = left > std::max(dependence * own, least_flexibility) ? left : 0;
  return answer;
}

/// Adds `length` times `change` to the active multipliers.
void DualActiveSet::push(const VectorXd& change, double length, VectorXd& violation) {
  for (std::size_t i = 0; i < active_.size(); ++i) {
    const double step = length * change[static_cast<Eigen::Index>(i)];
    multipliers_[active_[i]] += step;
    violation -= step * flexibility_.col(active_[i]).head(size());
  }
}

void DualActiveSet::activate(Eigen::Index row) {
  const auto count = static_cast<Eigen::Index>(active_.size());
  const Answer answer = answer_to(row);
  make_room(factor_, count + 1);
  factor_.row(count).head(count) = answer.half.transpose();
  factor_(count, count) = std::sqrt(std::max(answer.flexibility, std::numeric_limits<double>::min()));
  active_.push_back(row);
  is_active_[static_cast<std::size_t>(row)] = 1;
}

/// The rows that came later are factorised again.
void DualActiveSet::release(std::size_t place) {
  multipliers_[active_[place]] = 0;
  const std::vector<Eigen::Index> later(active_.begin() + static_cast<std::ptrdiff_t>(place) + 1, active_.end());
  is_active_[static_cast<std::size_t>(active_[place])] = 0;
  active_.resize(place);
  for (const Eigen::Index row : later) activate(row);
}

/// The first active row whose multiplier reaches 0 along `change`, and after what length of it.
struct Blocking {
  std::size_t place = 0;
  double length = infinity;
};

Blocking blocking_row(const VectorXd& multipliers, const VectorXd& change) {
  Blocking blocking;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    if (!(change[i] < 0)) continue;
    const double length = -multipliers[i] / change[i];
    if (length < blocking.length) blocking = {static_cast<std::size_t>(i), length};
  }
  return blocking;
}

/// Meets the active rows exactly again, after the numbers have changed a little.
DualActiveSet::Outcome DualActiveSet::settle(VectorXd& violation) {
  while (!active_.empty()) {
    const auto count = static_cast<Eigen::Index>(active_.size());
    const auto factor = factor_.topLeftCorner(count, count).triangularView<Eigen::Lower>();
    VectorXd change = factor.solve(active_part(violation));
    factor.transpose().solveInPlace(change);
    const Blocking blocking = blocking_row(active_part(multipliers_), change);
    push(change, std::min(1.0, blocking.length), violation);
    if (blocking.length >= 1) return Outcome::Solved;
    release(blocking.place);
    if (--changes_left_ < 0) return Outcome::GaveUp;
  }
  return Outcome::Solved;
}

/// Raises the multiplier of a violated row until it is met; active rows that would pull instead of push give way.
DualActiveSet::Outcome DualActiveSet::satisfy(Eigen::Index row, VectorXd& violation) {
  while (--changes_left_ >= 0) {
    const Answer answer = answer_to(row);
    if (answer.flexibility == 0 && violation[row] <= implied_violation) {
      is_implied_[static_cast<std::size_t>(row)] = 1;
      return Outcome::Solved;
    }
    const Blocking blocking = blocking_row(active_part(multipliers_), -answer.relief);
    const double whole = answer.flexibility > 0 ? violation[row] / answer.flexibility : infinity;
    const double length = std::min(whole, blocking.length);
    if (length == infinity) return Outcome::Contradictory;
    push(-answer.relief, length, violation);
    multipliers_[row] += length;
    violation -= length * flexibility_.col(row).head(size());
    if (whole <= blocking.length) {
      activate(row);
      return Outcome::Solved;
    }
    release(blocking.place);
  }
  return Outcome::GaveUp;
}

/// -1 when none is.
Eigen::Index DualActiveSet::most_violated(const VectorXd& violation, double tolerance) const {
  Eigen::Index worst = -1;
  double largest = tolerance;
  for (Eigen::Index row = 0; row < violation.size(); ++row) {
    const auto place = static_cast<std::size_t>(row);
    if (is_active_[place] != 0 || is_implied_[place] != 0 || violation[row] <= largest) continue;
    worst = row;
    largest = violation[row];
  }
  return worst;
}

DualActiveSet::Outcome DualActiveSet::solve(VectorXd& violation, double tolerance) {
  changes_left_ = changes_per_row * static_cast<int>(size());
  is_implied_.assign(is_implied_.size(), 0);
  Outcome outcome = settle(violation);
  while (outcome == Outcome::Solved) {
    const Eigen::Index row = most_violated(violation, tolerance);
    if (row < 0) break;
    outcome = satisfy(row, violation);
  }
  return outcome;
}

}  // namespace croquis
