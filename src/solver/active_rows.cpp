// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/active_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/row_flexibility.h"

namespace croquis {
namespace {

using Eigen::VectorXd;

using Outcome = DualActiveSet::Outcome;

constexpr int most_row_changes = 25;
/// Beyond this many rows the interior point's few factorisations are cheaper.
constexpr Eigen::Index most_rows = 1000;
/// Rows that may join in one round, or half as many as press already: few are wasted, and few rounds are needed.
constexpr Eigen::Index least_rows_per_round = 16;
/// The worst so many join even if they share unknowns: where all rows do, rounds would run out.
constexpr Eigen::Index always_taken = 4;
/// Relative error (see error()) that no further round is spent on.
constexpr double rounding_floor = 1e-13;

class Rounds {
 public:
  Rounds(const ElasticProblem& problem, const KktSystem& system);

  bool optimal();
  Outcome advance();
  int count() const { return count_; }
  ElasticPoint result() const;

 private:
  const ScaledProblem& matrices() const { return *problem_.matrices; }
  void find_residuals();
  std::vector<Eigen::Index> violated_rows() const;
  bool meets_taken_row(Eigen::Index row);
  void take_violated_rows();
  double error() const;

  const ElasticProblem& problem_;
  const KktSystem& system_;
  RowFlexibility flexibility_;
  DualActiveSet active_set_;
  std::vector<Eigen::Index> known_;  ///< row of each entry of the active set
  std::vector<char> is_known_;       ///< per row
  Eigen::VectorXi taken_in_round_;   ///< per unknown, the last round that took a row of it
  VectorXd y_, equality_, multipliers_;
  VectorXd stationarity_, equality_gap_, violation_;
  double last_error_ = std::numeric_limits<double>::infinity();
  double error_before_ = std::numeric_limits<double>::infinity();  ///< that of the round before the last
  int count_ = 0;
};

Rounds::Rounds(const ElasticProblem& problem, const KktSystem& system)
    : problem_(problem),
      system_(system),
      flexibility_(*problem.matrices, system),
      is_known_(static_cast<std::size_t>(problem.bounds.size()), 0),
      taken_in_round_(Eigen::VectorXi::Zero(system.unknowns())),
      y_(VectorXd::Zero(system.unknowns())),
      equality_(VectorXd::Zero(system.size() - system.unknowns())),
      multipliers_(VectorXd::Zero(problem.bounds.size())),
      stationarity_(y_),
      equality_gap_(equality_),
      violation_(problem.bounds) {}

void Rounds::find_residuals() {
  const ScaledProblem& m = matrices();
  stationarity_ = m.inequalities.transpose() * multipliers_ + m.equalities.transpose() * equality_ -
                  m.objective.transpose() * (m.objective * y_);
  equality_gap_ = -(m.equalities * y_);
  violation_ = problem_.bounds - m.inequalities * y_;
}

double Rounds::error() const {
  double rows = 0;
  for (Eigen::Index row = 0; row < violation_.size(); ++row)
    rows = std::max(rows, multipliers_[row] > 0 ? std::abs(violation_[row]) : violation_[row]);
  const double force = std::max(1.0, multipliers_.lpNorm<Eigen::Infinity>());
  return std::max({rows, equality_gap_.lpNorm<Eigen::Infinity>(), stationarity_.lpNorm<Eigen::Infinity>() / force});
}

/// True when the point passes and another round would gain nothing. What a round corrects of the unknowns' balance, the
/// next one corrects of the rows, so that only every second one need gain.
bool Rounds::optimal() {
  if (count_ == 0) return false;
  const double now = error();
  const bool stalled = now > 0.5 * error_before_;
  error_before_ = last_error_;
  last_error_ = now;
  return now <= rounding_floor || (now <= verification_tolerance && stalled);
}

/// The unknown rows that are violated, the worst first.
std::vector<Eigen::Index> Rounds::violated_rows() const {
  std::vector<Eigen::Index> violated;
  for (Eigen::Index row = 0; row < violation_.size(); ++row)
    if (violation_[row] > rounding_floor && is_known_[static_cast<std::size_t>(row)] == 0) violated.push_back(row);
  std::sort(violated.begin(), violated.end(), [this](Eigen::Index a, Eigen::Index b) {
    return violation_[a] > violation_[b] || (violation_[a] == violation_[b] && a < b);
  });
  return violated;
}

/// True when an unknown of the row belongs to one taken in this round; else marks its unknowns.
bool Rounds::meets_taken_row(Eigen::Index row) {
  bool meets = false;
  for (RowMatrix::InnerIterator entry(matrices().inequalities, row); entry; ++entry)
    meets = meets || taken_in_round_[entry.col()] == count_ + 1;
  for (RowMatrix::InnerIterator entry(matrices().inequalities, row); entry && !meets; ++entry)
    taken_in_round_[entry.col()] = count_ + 1;
  return meets;
}

/// Of rows that share an unknown the worst one comes first: it often settles the others.
void Rounds::take_violated_rows() {
  const Eigen::Index places = std::max(least_rows_per_round, static_cast<Eigen::Index>(active_set_.active_count() / 2));
  Eigen::Index taken = 0;
  for (const Eigen::Index row : violated_rows()) {
    if (meets_taken_row(row) && taken >= always_taken) continue;
    active_set_.add_row(flexibility_.add(row));
    known_.push_back(row);
    is_known_[static_cast<std::size_t>(row)] = 1;
    if (++taken == places) return;
  }
}

/// One round.
Outcome Rounds::advance() {
  take_violated_rows();
  if (active_set_.size() > most_rows) return Outcome::GaveUp;
  VectorXd known_violation(active_set_.size());
  for (Eigen::Index i = 0; i < known_violation.size(); ++i)
    known_violation[i] = violation_[known_[static_cast<std::size_t>(i)]];
  const Outcome outcome = active_set_.solve(known_violation, rounding_floor);
  if (outcome != Outcome::Solved) return outcome;

  VectorXd push = -multipliers_;
  for (Eigen::Index i = 0; i < known_violation.size(); ++i)
    multipliers_[known_[static_cast<std::size_t>(i)]] = active_set_.multipliers()[i];
  push += multipliers_;
  VectorXd right_side(system_.size());
  right_side.head(system_.unknowns()) = stationarity_ + matrices().inequalities.transpose() * push;
  right_side.tail(equality_.size()) = equality_gap_;
  const VectorXd change = system_.solve_regularised(right_side);
  y_ += change.head(system_.unknowns());
  equality_ -= change.tail(equality_.size());
  ++count_;
  find_residuals();
  return Outcome::Solved;
}

ElasticPoint Rounds::result() const {
  ElasticPoint point;
  point.y = y_;
  point.equality = equality_;
  point.multipliers = multipliers_;
  point.distance = (-violation_).cwiseMax(0.0);
  point.shortfall = violation_.cwiseMax(0.0);
  point.penalty = 2 * multipliers_.cwiseQuotient(problem_.prices).maxCoeff();
  point.slack_multipliers = point.penalty * problem_.prices - multipliers_;
  point.iterations = count_;
  point.converged = true;
  return point;
}

}  // namespace

DualActiveSet::Outcome find_active_rows(const ElasticProblem& problem, const KktSystem& system, ElasticPoint& point,
                                        Progress& progress) {
  Rounds rounds(problem, system);
  while (!rounds.optimal()) {
    if (rounds.count() == most_row_changes) return Outcome::GaveUp;
    progress.check();
    const Outcome outcome = rounds.advance();
    if (outcome != Outcome::Solved) return outcome;
    progress.report(1 - std::pow(0.85, rounds.count()));
  }
  point = rounds.result();
  return Outcome::Solved;
}

}  // namespace croquis
