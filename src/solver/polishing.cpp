// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/polishing.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace croquis {
namespace {

using Eigen::VectorXd;

/// Weight of an active row in K(D): its own multiplier's regularisation, the inverse of what equalities get.
constexpr double active_weight = 1e8;
/// Largest error of a point that passes, relative to the largest violation of the start (and for multipliers to the
/// largest of them).
constexpr int most_polishing_rounds = 6;

/// What a row does at the optimum.
enum class Role {
  Idle,    ///< G y > b: no multiplier
  Active,  ///< G y = b
  Short    ///< G y < b: the multiplier is the full price
};

struct Candidate {
  VectorXd y, equality, multipliers;
};

class Polishing {
 public:
  Polishing(const ElasticProblem& problem, KktSystem& system, const ElasticPoint& point);

  bool round();
  bool correct_roles();

  ElasticPoint result() const;

 private:
  double price(Eigen::Index row) const { return start_.penalty * problem_.prices[row]; }
  bool is(Eigen::Index row, Role role) const { return roles_[static_cast<std::size_t>(row)] == role; }
  void prepare();
  double refine();

  const ElasticProblem& problem_;
  KktSystem& system_;
  const ElasticPoint& start_;
  std::vector<Role> roles_;
  Candidate candidate_;
  VectorXd row_weights_;
  double multiplier_scale_ = 1;
};

Polishing::Polishing(const ElasticProblem& problem, KktSystem& system, const ElasticPoint& point)
    : problem_(problem), system_(system), start_(point), roles_(static_cast<std::size_t>(problem.bounds.size())) {
  for (Eigen::Index row = 0; row < problem.bounds.size(); ++row) {
    Role role = point.multipliers[row] > point.distance[row] ? Role::Active : Role::Idle;
    if (role == Role::Active && point.shortfall[row] > point.slack_multipliers[row]) role = Role::Short;
    roles_[static_cast<std::size_t>(row)] = role;
  }
}

/// The candidate starts at the interior point, with the multipliers that the roles demand.
void Polishing::prepare() {
  candidate_ = {start_.y, start_.equality, start_.multipliers};
  row_weights_ = VectorXd::Zero(problem_.bounds.size());
  for (Eigen::Index row = 0; row < problem_.bounds.size(); ++row) {
    if (is(row, Role::Idle)) candidate_.multipliers[row] = 0;
    if (is(row, Role::Short)) candidate_.multipliers[row] = price(row);
    if (is(row, Role::Active)) row_weights_[row] = active_weight;
  }
  multiplier_scale_ = std::max(1.0, candidate_.multipliers.lpNorm<Eigen::Infinity>());
}

/// One step of the method of multipliers; returns the error before it.
double Polishing::refine() {
  const ScaledProblem& m = *problem_.matrices;
  const VectorXd stationarity = m.inequalities.transpose() * candidate_.multipliers +
                                m.equalities.transpose() * candidate_.equality -
                                m.objective.transpose() * (m.objective * candidate_.y);
  const VectorXd equality = -(m.equalities * candidate_.y);
  VectorXd rows = problem_.bounds - m.inequalities * candidate_.y;
  for (Eigen::Index row = 0; row < rows.size(); ++row)
    if (!is(row, Role::Active)) rows[row] = 0;

  VectorXd right_side(system_.size());
  right_side.head(system_.unknowns()) = stationarity + m.inequalities.transpose() * row_weights_.cwiseProduct(rows);
  right_side.tail(equality.size()) = equality;
  const VectorXd solution = system_.solve_regularised(right_side);
  const VectorXd change = solution.head(system_.unknowns());
  candidate_.y += change;
  candidate_.equality -= solution.tail(equality.size());
  candidate_.multipliers += row_weights_.cwiseProduct(rows - m.inequalities * change);
  return std::max({stationarity.lpNorm<Eigen::Infinity>() / multiplier_scale_, equality.lpNorm<Eigen::Infinity>(),
                   rows.lpNorm<Eigen::Infinity>()});
}

/// Solves for the present roles; true when the equations are met.
bool Polishing::round() {
  prepare();
  if (!system_.factorise(row_weights_)) return false;
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_refinements; ++step) {
    const double error = refine();
    // The rounding floor: no further digit can be gained.
    if (error <= 1e-3 * verification_tolerance || (error <= verification_tolerance && error > 0.5 * best)) return true;
    best = std::min(best, error);
  }
  return best <= verification_tolerance;
}

/// Gives each row that contradicts its role the right one; true when none did.
bool Polishing::correct_roles() {
  const VectorXd margin = problem_.matrices->inequalities * candidate_.y - problem_.bounds;
  const double slope_tolerance = verification_tolerance * multiplier_scale_;
  bool right = true;
  for (Eigen::Index row = 0; row < margin.size(); ++row) {
    Role& role = roles_[static_cast<std::size_t>(row)];
    Role demanded = role;
    if (role == Role::Idle && margin[row] < -verification_tolerance) demanded = Role::Active;
    if (role == Role::Short && margin[row] > verification_tolerance) demanded = Role::Active;
    if (role == Role::Active && candidate_.multipliers[row] < -slope_tolerance) demanded = Role::Idle;
    if (role == Role::Active && candidate_.multipliers[row] > price(row) + slope_tolerance) demanded = Role::Short;
    right = right && demanded == role;
    role = demanded;
  }
  return right;
}

ElasticPoint Polishing::result() const {
  ElasticPoint polished = start_;
  polished.y = candidate_.y;
  polished.equality = candidate_.equality;
  const VectorXd prices = start_.penalty * problem_.prices;
  polished.multipliers = candidate_.multipliers.cwiseMax(0.0).cwiseMin(prices);
  polished.slack_multipliers = prices - polished.multipliers;
  const VectorXd margin = problem_.matrices->inequalities * candidate_.y - problem_.bounds;
  polished.distance = margin.cwiseMax(0.0);
  polished.shortfall = (-margin).cwiseMax(0.0);
  return polished;
}

}  // namespace

bool polish(const ElasticProblem& problem, KktSystem& system, ElasticPoint& point, const Progress& progress) {
  Polishing polishing(problem, system, point);
  for (int round = 0; round < most_polishing_rounds; ++round) {
    progress.check();
    if (!polishing.round()) return false;
    if (!polishing.correct_roles()) continue;
    point = polishing.result();
    return true;
  }
  return false;
}

}  // namespace croquis
