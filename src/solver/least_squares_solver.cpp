// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/solver/least_squares_solver.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/base/error.h"
#include "croquis/solver/least_squares.h"
#include "solver/active_rows.h"
#include "solver/elastic_optimum.h"
#include "solver/kkt_system.h"

namespace croquis {
namespace {

/// The scaled least-squares optimum under the equalities alone.
struct EqualityOptimum {
  Eigen::VectorXd y;         ///< N
  Eigen::VectorXd equality;  ///< multipliers nu, #E: U^T (U y - t) = E^T nu
};

using Eigen::VectorXd;

/// |U v|^2 of a unit direction that counts as none: rounding leaves 1e-20 there, the flattest plate of 30 000 vertices
/// bends with 1e-9.
constexpr double flat_curvature = 1e-13;
constexpr int inverse_iterations = 3;

/// Reproducible numbers in [-1, 1) without structure (Knuth's linear congruential generator).
VectorXd scattered(Eigen::Index size) {
  VectorXd values(size);
  std::uint64_t state = 1;
  for (double& value : values) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    value = static_cast<double>(static_cast<std::int64_t>(state) >> 11) / static_cast<double>(std::int64_t{1} << 52);
  }
  return values;
}

/// Solves with the factorisation of K(0) that `system` holds. Equalities that contradict each other are met in the
/// least-squares sense, so that each of them shows a residual.
EqualityOptimum find_equality_optimum(const ScaledProblem& problem, const KktSystem& system, const VectorXd& target,
                                      const VectorXd& equality_values) {
  EqualityOptimum optimum{VectorXd::Zero(system.unknowns()), VectorXd::Zero(equality_values.size())};
  if (system.size() == 0) return optimum;
  double last_change = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= most_refinements; ++round) {
    VectorXd residual(system.size());
    residual.head(system.unknowns()) = problem.objective.transpose() * (target - problem.objective * optimum.y) +
                                       problem.equalities.transpose() * optimum.equality;
    residual.tail(equality_values.size()) = equality_values - problem.equalities * optimum.y;
    const VectorXd change = system.solve_regularised(residual);
    const double size = change.head(system.unknowns()).lpNorm<Eigen::Infinity>();
    if (!(size < 0.5 * last_change)) break;
    optimum.y += change.head(system.unknowns());
    optimum.equality -= change.tail(equality_values.size());
    // Each round gains as many digits as the last: what the next one could change is below rounding.
    const double next_change = std::isfinite(last_change) ? size * (size / last_change) : size;
    if (next_change <= std::numeric_limits<double>::epsilon() * optimum.y.lpNorm<Eigen::Infinity>()) break;
    last_change = size;
  }
  return optimum;
}

/// True when the objective has no curvature in some direction that the equalities allow. Inverse iteration with the
/// factorisation of K(0): the regularisation is the smallest curvature then, and such a direction wins at once.
bool has_flat_direction(const ScaledProblem& problem, const KktSystem& system) {
  if (system.unknowns() == 0) return false;
  VectorXd direction = VectorXd::Zero(system.size());
  direction.head(system.unknowns()) = scattered(system.unknowns());
  for (int round = 0; round < inverse_iterations; ++round) {
    direction = system.solve_regularised(direction);
    direction.tail(system.size() - system.unknowns()).setZero();
    direction.normalize();
  }
  return (problem.objective * direction.head(system.unknowns())).squaredNorm() < flat_curvature;
}

using Matrix = Eigen::SparseMatrix<double>;

Finding solver_error(std::string message) { return make_error(Category::Internal, "E_SOLVER", std::move(message)); }

std::string size_text(Eigen::Index rows, Eigen::Index columns) {
  return std::to_string(rows) + " by " + std::to_string(columns);
}

/// A matrix without rows may have any width.
void check_matrix(Matrix& matrix, Eigen::Index unknowns, const std::string& name, Findings& findings) {
  matrix.makeCompressed();
  if (matrix.rows() == 0) matrix = Matrix(0, unknowns);
  if (matrix.cols() != unknowns)
    findings.push_back(solver_error("The matrix of the " + name + " is " + size_text(matrix.rows(), matrix.cols()) +
                                    ", but there are " + std::to_string(unknowns) + " unknowns; give it that width."));
  const Eigen::Map<const Eigen::VectorXd> values(matrix.valuePtr(), matrix.nonZeros());
  if (!values.allFinite())
    findings.push_back(
        solver_error("The matrix of the " + name + " holds a number that is not finite; check the rows' geometry."));
}

void check_vector(const Eigen::VectorXd& vector, Eigen::Index size, const std::string& name, Findings& findings) {
  if (vector.size() != size)
    findings.push_back(solver_error("There are " + std::to_string(vector.size()) + " " + name + " for " +
                                    std::to_string(size) + " rows; give one for each."));
  for (Eigen::Index row = 0; row < vector.size(); ++row) {
    if (std::isfinite(vector[row])) continue;
    findings.push_back(solver_error("Number " + std::to_string(row) + " of the " + name +
                                    " is not finite; check the geometry it comes from."));
    return;
  }
}

void complete_vector(Eigen::VectorXd& vector, Eigen::Index size) {
  if (vector.size() == 0) vector = Eigen::VectorXd::Zero(size);
}

/// The same problem with every matrix N columns wide, every vector as long as its matrix has rows, all compressed.
/// @throws Error (E_SOLVER), one finding per part whose size doesn't fit or that holds a number that isn't finite
LeastSquaresProblem checked_and_completed(LeastSquaresProblem problem) {
  const Eigen::Index unknowns =
      std::max({problem.objective.cols(), problem.equalities.cols(), problem.inequalities.cols()});
  Findings findings;
  check_matrix(problem.objective, unknowns, "objective", findings);
  check_matrix(problem.equalities, unknowns, "equalities", findings);
  check_matrix(problem.inequalities, unknowns, "inequalities", findings);

  complete_vector(problem.target, problem.objective.rows());
  complete_vector(problem.equality_values, problem.equalities.rows());
  complete_vector(problem.inequality_bounds, problem.inequalities.rows());
  check_vector(problem.target, problem.objective.rows(), "targets", findings);
  check_vector(problem.equality_values, problem.equalities.rows(), "equality values", findings);
  check_vector(problem.inequality_bounds, problem.inequalities.rows(), "inequality bounds", findings);
  if (!findings.empty()) throw Error(std::move(findings));
  return problem;
}

/// Checks new numbers for an old place. @throws Error (E_SOLVER)
void check_replacement(const Eigen::VectorXd& vector, Eigen::Index size, const char* name) {
  Findings findings;
  check_vector(vector, size, name, findings);
  if (!findings.empty()) throw Error(std::move(findings));
}

/// |bound_q| + sum over j of |A_qj x_j|: the scale that a row's residual is judged by, whatever its unit.
template <typename Matrix>
Eigen::VectorXd row_sizes(const Matrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& bounds) {
  return bounds.cwiseAbs() + matrix.cwiseAbs() * x.cwiseAbs();
}

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

LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
                                         Progress& progress) {
  return LeastSquaresSolver(problem, options).solve(progress);
}

}  // namespace croquis
