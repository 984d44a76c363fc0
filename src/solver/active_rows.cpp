// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/active_rows.h"

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

using Eigen::VectorXd;

RowFlexibility::RowFlexibility(const ScaledProblem& problem, const KktSystem& system)
    : problem_(problem), system_(system), work_(VectorXd::Zero(system.size())) {}

/// Puts the row into the factors' order; returns where its entries are.
std::vector<int> RowFlexibility::start(Eigen::Index row) {
  std::vector<int> places;
  const auto& order = system_.factors().permutationP().indices();
  for (RowMatrix::InnerIterator entry(problem_.inequalities, row); entry; ++entry) {
    const int place = order.size() > 0 ? order[entry.col()] : static_cast<int>(entry.col());
    work_[place] += entry.value();
    places.push_back(place);
  }
  return places;
}

/// All places on the paths to the root, ascending. A column's parent is its first entry below the diagonal.
std::vector<int> RowFlexibility::reached(std::vector<int> start) const {
  const auto& lower = system_.factors().matrixL().nestedExpression();
  std::vector<int> places;
  std::vector<int> merged;
  for (const int first : start) {
    std::vector<int> path{first};
    for (int place = first;;) {
      const int begin = lower.outerIndexPtr()[place];
      if (begin == lower.outerIndexPtr()[place + 1]) break;
      place = lower.innerIndexPtr()[begin];
      // Where two paths meet they stay together.
      if (std::binary_search(places.begin(), places.end(), place)) break;
      path.push_back(place);
    }
    merged.clear();
    std::set_union(places.begin(), places.end(), path.begin(), path.end(), std::back_inserter(merged));
    places.swap(merged);
  }
  return places;
}

RowFlexibility::HalfSolution RowFlexibility::half_solve(Eigen::Index row) {
  HalfSolution half;
  half.places = reached(start(row));
  half.values.resize(static_cast<Eigen::Index>(half.places.size()));
  const auto& lower = system_.factors().matrixL().nestedExpression();
  Eigen::Index next = 0;
  for (const int place : half.places) {
    const double value = work_[place];
    half.values[next++] = value;
    work_[place] = 0;
    for (int k = lower.outerIndexPtr()[place]; k < lower.outerIndexPtr()[place + 1]; ++k)
      work_[lower.innerIndexPtr()[k]] -= lower.valuePtr()[k] * value;
  }
  return half;
}

VectorXd RowFlexibility::add(Eigen::Index row) {
  halves_.push_back(half_solve(row));
  const HalfSolution& last = halves_.back();
  const auto& pivots = system_.factors().vectorD();
  for (std::size_t i = 0; i < last.places.size(); ++i)
    work_[last.places[i]] = last.values[static_cast<Eigen::Index>(i)] / pivots[last.places[i]];

  VectorXd flexibility(static_cast<Eigen::Index>(halves_.size()));
  for (std::size_t h = 0; h < halves_.size(); ++h) {
    double product = 0;
    for (std::size_t i = 0; i < halves_[h].places.size(); ++i)
      product += work_[halves_[h].places[i]] * halves_[h].values[static_cast<Eigen::Index>(i)];
    flexibility[static_cast<Eigen::Index>(h)] = product;
  }
  for (const int place : last.places) work_[place] = 0;
  return flexibility;
}

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
