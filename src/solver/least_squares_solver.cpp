// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/solver/least_squares_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "solver/active_rows.h"
#include "solver/elastic_optimum.h"
#include "solver/equality_optimum.h"
#include "solver/interior_point.h"
#include "solver/kkt_system.h"
#include "solver/problem_check.h"
#include "solver/row_sizes.h"
#include "solver/scaled_problem.h"

namespace croquis {
namespace {

using Eigen::VectorXd;

/// A violation below this part of the row's terms is rounding.
constexpr double rounding_tolerance = 1e-12;
/// Rows that are met by more than this many times the largest violation count as met by this much: none of them gets
/// in the way, and larger numbers would hide the others by their rounding errors.
constexpr double farthest_row = 1e7;
/// Rows whose lengths differ by more than this are priced as if by this: beyond it, prices lose their digits.
constexpr double widest_price_range = 1e4;
/// Share of the work before the interior point starts, where there is one.
constexpr double first_share = 0.1;

/// What a unit of each scaled row's shortfall costs, so that all rows pay the same per unit of their own.
VectorXd prices(const VectorXd& inequality_scale) {
  const VectorXd lengths = inequality_scale.cwiseInverse();
  return (lengths / lengths.minCoeff()).cwiseMin(widest_price_range);
}

}  // namespace

struct LeastSquaresSolver::State {
  State(LeastSquaresProblem given, LeastSquaresOptions chosen)
      : problem(checked_and_completed(std::move(given))),
        options(chosen),
        scaled(scale(problem)),
        rest_system(std::make_unique<KktSystem>(scaled, KktSystem::Rows::None)) {}

  void factorise_at_rest();
  LeastSquaresSolution solve(Progress& progress);

  LeastSquaresProblem problem;
  LeastSquaresOptions options;
  ScaledProblem scaled;
  std::unique_ptr<KktSystem> rest_system;      ///< K(0)
  std::unique_ptr<KktSystem> weighted_system;  ///< K(D), made when the interior point is needed first
  bool at_rest = false;                        ///< rest_system holds its factors
  bool flat = false;                           ///< the objective has a flat direction

 private:
  int factorisations() const {
    return rest_system->factorisations() + (weighted_system ? weighted_system->factorisations() : 0);
  }
  VectorXd violations(const VectorXd& y) const;
  ElasticPoint optimum_of_all_rows(const ElasticProblem& elastic, Progress& progress);
  void solve_elastic(const VectorXd& violation, double unit, EqualityOptimum& optimum, LeastSquaresSolution& solution,
                     Progress& progress);
  void report_rows(LeastSquaresSolution& solution) const;
  void report_stationarity(LeastSquaresSolution& solution) const;
};

void LeastSquaresSolver::State::factorise_at_rest() {
  if (at_rest) return;
  if (!rest_system->factorise(VectorXd()))
    throw Error(make_error(Category::Internal, "E_SOLVER",
                           "The least-squares system can't be factorised; check its numbers for overflow."));
  flat = has_flat_direction(scaled, *rest_system);
  at_rest = true;
}

/// h - G y per scaled row; rows without entries don't constrain y and count as met here.
VectorXd LeastSquaresSolver::State::violations(const VectorXd& y) const {
  VectorXd violation = scaled.inequality_scale.cwiseProduct(problem.inequality_bounds) - scaled.inequalities * y;
  for (Eigen::Index row = 0; row < violation.size(); ++row)
    if (scaled.inequalities.row(row).nonZeros() == 0) violation[row] = -std::numeric_limits<double>::infinity();
  return violation;
}

LeastSquaresSolution LeastSquaresSolver::State::solve(Progress& progress) {
  progress.check();
  const int factorisations_before = factorisations();
  factorise_at_rest();
  progress.report(first_share);

  EqualityOptimum optimum = find_equality_optimum(scaled, *rest_system, problem.target,
                                                  scaled.equality_scale.cwiseProduct(problem.equality_values));
  LeastSquaresSolution solution;
  solution.multipliers = VectorXd::Zero(problem.inequalities.rows());
  const VectorXd violation = violations(optimum.y);
  const VectorXd sizes =
      row_sizes(scaled.inequalities, optimum.y, scaled.inequality_scale.cwiseProduct(problem.inequality_bounds));
  double unit = 0;
  for (Eigen::Index row = 0; row < violation.size(); ++row)
    if (violation[row] > rounding_tolerance * sizes[row]) unit = std::max(unit, violation[row]);
  if (unit > 0) solve_elastic(violation, unit, optimum, solution, progress);

  solution.x = scaled.column_scale.cwiseProduct(optimum.y);
  solution.equality_multipliers = scaled.equality_scale.cwiseProduct(optimum.equality);
  solution.factorisations = factorisations() - factorisations_before;
  solution.singular_objective = flat;
  report_rows(solution);
  report_stationarity(solution);
  progress.report(1);
  return solution;
}

/// By the few rows that press where that succeeds, else by the interior point.
ElasticPoint LeastSquaresSolver::State::optimum_of_all_rows(const ElasticProblem& elastic, Progress& progress) {
  ElasticPoint point;
  DualActiveSet::Outcome outcome = DualActiveSet::Outcome::GaveUp;
  if (!flat) outcome = find_active_rows(elastic, *rest_system, point, progress);
  if (outcome == DualActiveSet::Outcome::Solved) return point;
  if (!weighted_system) weighted_system = std::make_unique<KktSystem>(scaled, KktSystem::Rows::Weighted);
  return find_elastic_optimum(elastic, *weighted_system, options, outcome == DualActiveSet::Outcome::Contradictory,
                              progress);
}

/// Moves the optimum of the equalities to that of all rows.
void LeastSquaresSolver::State::solve_elastic(const VectorXd& violation, double unit, EqualityOptimum& optimum,
                                              LeastSquaresSolution& solution, Progress& progress) {
  const ElasticProblem elastic{&scaled, (violation / unit).cwiseMax(-farthest_row), prices(scaled.inequality_scale)};
  Progress part = progress.step("separating parts", 1 - first_share);
  const ElasticPoint point = optimum_of_all_rows(elastic, part);
  optimum.y += unit * point.y;
  optimum.equality += unit * point.equality;
  solution.multipliers = unit * scaled.inequality_scale.cwiseProduct(point.multipliers);
  solution.iterations = point.iterations;
  solution.converged = point.converged;
}

void LeastSquaresSolver::State::report_rows(LeastSquaresSolution& solution) const {
  const auto judge = [&](const VectorXd& residual, const VectorXd& sizes, std::vector<int>& failed) {
    for (Eigen::Index row = 0; row < residual.size(); ++row) {
      if (residual[row] > options.row_tolerance * sizes[row])
        failed.push_back(static_cast<int>(row));
      else if (residual[row] > 0)
        solution.primal_residual = std::max(solution.primal_residual, residual[row] / sizes[row]);
    }
  };
  solution.shortfall = (problem.inequality_bounds - problem.inequalities * solution.x).cwiseMax(0.0);
  judge(solution.shortfall, row_sizes(problem.inequalities, solution.x, problem.inequality_bounds),
        solution.violated_rows);
  judge((problem.equality_values - problem.equalities * solution.x).cwiseAbs(),
        row_sizes(problem.equalities, solution.x, problem.equality_values), solution.contradictory_equalities);
}

/// In the scaled unknowns, where the entries have one unit.
void LeastSquaresSolver::State::report_stationarity(LeastSquaresSolution& solution) const {
  const VectorXd& c = scaled.column_scale;
  const VectorXd residual = problem.objective * solution.x - problem.target;
  const VectorXd slope = c.cwiseProduct(problem.objective.transpose() * residual);
  const VectorXd equalities = c.cwiseProduct(problem.equalities.transpose() * solution.equality_multipliers);
  const VectorXd inequalities = c.cwiseProduct(problem.inequalities.transpose() * solution.multipliers);
  const double terms = std::max(
      {c.cwiseProduct(problem.objective.transpose() * problem.target).lpNorm<Eigen::Infinity>(),
       slope.lpNorm<Eigen::Infinity>(), equalities.lpNorm<Eigen::Infinity>(), inequalities.lpNorm<Eigen::Infinity>()});
  const VectorXd stationarity = slope - equalities - inequalities;
  if (terms > 0) solution.dual_residual = stationarity.lpNorm<Eigen::Infinity>() / terms;
  VectorXd right_side = VectorXd::Zero(rest_system->size());
  right_side.head(stationarity.size()) = -stationarity;
  if (right_side.size() > 0) right_side = rest_system->solve_regularised(right_side);
  solution.remaining_step = c.cwiseProduct(right_side.head(stationarity.size()));
}

LeastSquaresSolver::LeastSquaresSolver(LeastSquaresProblem problem, LeastSquaresOptions options)
    : state_(std::make_unique<State>(std::move(problem), options)) {}
LeastSquaresSolver::~LeastSquaresSolver() = default;
LeastSquaresSolver::LeastSquaresSolver(LeastSquaresSolver&&) noexcept = default;
LeastSquaresSolver& LeastSquaresSolver::operator=(LeastSquaresSolver&&) noexcept = default;

void LeastSquaresSolver::set_target(VectorXd target) {
  check_replacement(target, state_->problem.objective.rows(), "targets");
  state_->problem.target = std::move(target);
}

void LeastSquaresSolver::set_inequality_bounds(VectorXd inequality_bounds) {
  check_replacement(inequality_bounds, state_->problem.inequalities.rows(), "inequality bounds");
  state_->problem.inequality_bounds = std::move(inequality_bounds);
}

LeastSquaresSolution LeastSquaresSolver::solve(Progress& progress) { return state_->solve(progress); }

}  // namespace croquis
