// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic_optimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace croquis {
namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;

/// The penalty is raised while it is below this multiple of the largest multiplier: the margin that makes it exact.
constexpr double penalty_margin = 10;
constexpr double penalty_growth = 1e2;
/// Rows that contradict each other take any price, so raising has to end: 1e2 * 1e2^2 leaves 10 digits for the rest.
/// Raised early, while products are large: late raises throw the method back by many steps.
constexpr int most_raises = 2;
/// Part of the distance to the nearest bound that a step may go; approaches 1 as the products approach 0.
constexpr double shortest_reach = 0.9;
/// Nothing may arrive at its bound: 0 multiplied or divided by 0 is no number.
constexpr double longest_reach = 1 - 1e-8;
/// Added to the inverse of a row's weight: a weight above 1e12 would leave H, whose diagonal is 1, no digits.
constexpr double softest_row = 1e-12;
/// Of the corrector; the predictor's digits are thrown away.
constexpr int corrector_refinements = 2;

struct Residuals {
  VectorXd stationarity;  ///< G^T lambda + E^T nu - H y
  VectorXd equality;      ///< -E y
  VectorXd rows;          ///< b - G y - s + w
};

struct Step {
  VectorXd y, equality, distance, shortfall, multipliers;  ///< that of mu is minus that of lambda
};

class Run {
 public:
  Run(const ElasticProblem& problem, KktSystem& system, ElasticPoint& start)
      : point(start), problem_(problem), system_(system) {}

  bool converged(double tolerance, double complementarity);
  void raise_penalty();
  bool iterate();

  ElasticPoint& point;

 private:
  double mean_product() const;
  Step direction(const VectorXd& distance_target, const VectorXd& shortfall_target, int refinements) const;
  double reach(const Step& step) const;
  void move(const Step& step, double length);
  double centring(const Step& predictor) const;

  const ScaledProblem& matrices() const { return *problem_.matrices; }

  const ElasticProblem& problem_;
  KktSystem& system_;
  Residuals residuals_;
  VectorXd row_weights_;
};

double Run::mean_product() const {
  const double sum = point.distance.dot(point.multipliers) + point.shortfall.dot(point.slack_multipliers);
  return sum / static_cast<double>(2 * point.distance.size());
}

bool Run::converged(double tolerance, double complementarity) {
  const ScaledProblem& m = matrices();
  residuals_.stationarity = m.inequalities.transpose() * point.multipliers + m.equalities.transpose() * point.equality -
                            m.objective.transpose() * (m.objective * point.y);
  residuals_.equality = -(m.equalities * point.y);
  residuals_.rows = problem_.bounds - m.inequalities * point.y - point.shortfall + point.distance;
  const double multiplier_scale = std::max(1.0, point.multipliers.lpNorm<Eigen::Infinity>());
  const double way_scale = std::max(1.0, point.y.lpNorm<Eigen::Infinity>());
  return residuals_.rows.lpNorm<Eigen::Infinity>() <= tolerance * way_scale &&
         residuals_.equality.lpNorm<Eigen::Infinity>() <= tolerance * way_scale &&
         residuals_.stationarity.lpNorm<Eigen::Infinity>() <= tolerance * multiplier_scale &&
         mean_product() <= complementarity;
}

/// Raising the price of shortfalls adds to mu alone and leaves the stationarity untouched.
void Run::raise_penalty() {
  const double largest = point.multipliers.cwiseQuotient(problem_.prices).maxCoeff();
  if (point.penalty_raises == most_raises || point.penalty >= penalty_margin * largest) return;
  ++point.penalty_raises;
  const double raised = point.penalty * penalty_growth;
  point.slack_multipliers += (raised - point.penalty) * problem_.prices;
  point.penalty = raised;
}

/// Newton's direction for w lambda -> distance_target and s mu -> shortfall_target (the targets hold second-order
/// terms).
Step Run::direction(const VectorXd& distance_target, const VectorXd& shortfall_target, int refinements) const {
  const ScaledProblem& m = matrices();
  const VectorXd distance_gap = distance_target - point.distance.cwiseProduct(point.multipliers);
  const VectorXd shortfall_gap = shortfall_target - point.shortfall.cwiseProduct(point.slack_multipliers);
  const VectorXd row_gap = residuals_.rows - shortfall_gap.cwiseQuotient(point.slack_multipliers) +
                           distance_gap.cwiseQuotient(point.multipliers);

  VectorXd right_side(system_.size());
  right_side.head(system_.unknowns()) =
      residuals_.stationarity + m.inequalities.transpose() * row_weights_.cwiseProduct(row_gap);
  right_side.tail(residuals_.equality.size()) = residuals_.equality;
  const VectorXd solution = system_.solve(right_side, refinements);

  Step step;
  step.y = solution.head(system_.unknowns());
  step.equality = -solution.tail(residuals_.equality.size());
  step.multipliers = row_weights_.cwiseProduct(row_gap - m.inequalities * step.y);
  step.distance = (distance_gap - point.distance.cwiseProduct(step.multipliers)).cwiseQuotient(point.multipliers);
  step.shortfall =
      (shortfall_gap + point.shortfall.cwiseProduct(step.multipliers)).cwiseQuotient(point.slack_multipliers);
  return step;
}

/// The longest step that keeps `values` >= 0; infinite when all of them grow.
double longest(const VectorXd& values, const VectorXd& change) {
  double length = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (change[i] < 0) length = std::min(length, -values[i] / change[i]);
  return length;
}

double Run::reach(const Step& step) const {
  return std::min({longest(point.distance, step.distance), longest(point.shortfall, step.shortfall),
                   longest(point.multipliers, step.multipliers), longest(point.slack_multipliers, -step.multipliers)});
}

void Run::move(const Step& step, double length) {
  point.y += length * step.y;
  point.equality += length * step.equality;
  point.distance += length * step.distance;
  point.shortfall += length * step.shortfall;
  point.multipliers += length * step.multipliers;
  point.slack_multipliers -= length * step.multipliers;
}

/// How much to centre, from how far the predictor gets: its share of products left, cubed.
double Run::centring(const Step& predictor) const {
  ElasticPoint predicted = point;
  Run(problem_, system_, predicted).move(predictor, std::min(1.0, reach(predictor)));
  const double share = Run(problem_, system_, predicted).mean_product() / mean_product();
  return std::pow(std::clamp(share, 0.0, 1.0), 3);
}

/// One step; false, and nothing done, when the matrix can't be factorised.
bool Run::iterate() {
  row_weights_ = (point.distance.array() / point.multipliers.array() +
                  point.shortfall.array() / point.slack_multipliers.array() + softest_row)
                     .inverse();
  if (!system_.factorise(row_weights_)) return false;

  // Predictor: straight for the optimum.
  const VectorXd none = VectorXd::Zero(problem_.bounds.size());
  const Step predictor = direction(none, none, 0);

  // Corrector: towards equal products, with the predictor's second-order error taken out.
  const double mean = mean_product();
  const VectorXd target = VectorXd::Constant(problem_.bounds.size(), centring(predictor) * mean);
  const Step corrector =
      direction(target - predictor.distance.cwiseProduct(predictor.multipliers),
                target + predictor.shortfall.cwiseProduct(predictor.multipliers), corrector_refinements);
  const double caution = std::clamp(1 - mean, shortest_reach, longest_reach);
  move(corrector, std::min(1.0, caution * reach(corrector)));
  ++point.iterations;
  return true;
}

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

/// Replaces a converged point by the exact optimum of the rows that it shows as active, when that verifies.
///
/// An interior point ends at a distance of the optimum, the square root of its tolerance where a row just touches;
/// the rows' roles are clear by then. With active rows as equations and short rows at their full price the optimum is
/// linear: one factorisation (a few when a role turns out wrong), refined by the method of multipliers.
///
/// @return false, and the point untouched, when no choice of roles verifies
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

/// How much closer the interior point goes when the first polishing finds no roles that verify.
constexpr double second_effort = 1e-3;

/// Shortfall of rows that hold, in units of the largest violation: polishing leaves less.
constexpr double rounding_shortfall = 1e-9;
/// First price of the second attempt: where the first one ended.
constexpr double second_price = 1e6;
/// Steps of the second attempt leave room for those of the first (25 at most where rows can hold) and for polishing.
constexpr int second_steps = 25;
constexpr int most_factorisations = 40;
constexpr int polishing_reserve = 4;

bool falls_short(const ElasticPoint& point) { return point.shortfall.maxCoeff() > rounding_shortfall; }

ElasticPoint attempt(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                     ElasticPoint point, Progress& progress) {
  run_interior_point(problem, system, options, options.complementarity_tolerance, point, progress);
  if (point.converged && !polish(problem, system, point, progress)) {
    // Many rows that only just touch: their roles show a few steps later.
    run_interior_point(problem, system, options, second_effort * options.complementarity_tolerance, point, progress);
    if (point.converged) polish(problem, system, point, progress);
    point.converged = true;
  }
  return point;
}

}  // namespace

/// Every row starts satisfied at a distance of 1 (the largest violation) or more, by a shortfall where it must: steps
/// are not held up by rows that can't be met.
ElasticPoint starting_point(const ElasticProblem& problem, double penalty) {
  ElasticPoint point;
  point.penalty = penalty;
  point.y = VectorXd::Zero(problem.matrices->objective.cols());
  point.equality = VectorXd::Zero(problem.matrices->equalities.rows());
  point.distance = (-problem.bounds).cwiseMax(0.0).array() + 1;
  point.shortfall = problem.bounds.cwiseMax(0.0).array() + 1;
  point.multipliers = point.distance.cwiseInverse().cwiseMin(0.5 * point.penalty * problem.prices);
  point.slack_multipliers = point.penalty * problem.prices - point.multipliers;
  return point;
}

void run_interior_point(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                        double complementarity, ElasticPoint& point, Progress& progress) {
  Run run(problem, system, point);
  while (!(point.converged = run.converged(options.primal_tolerance, complementarity)) &&
         point.iterations < options.max_iterations) {
    progress.check();
    if (!run.iterate()) return;
    run.raise_penalty();
    // The number of steps isn't known beforehand: each takes a part of what is left.
    progress.report(1 - std::pow(0.85, point.iterations));
  }
}

ElasticPoint find_elastic_optimum(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                  bool contradictory, Progress& progress) {
  const int before = system.factorisations();
  ElasticPoint first = attempt(problem, system, options, starting_point(problem), progress);
  if (contradictory || !first.converged || !falls_short(first)) return first;

  LeastSquaresOptions bounded = options;
  const int left = most_factorisations - polishing_reserve - (system.factorisations() - before);
  bounded.max_iterations = std::min({options.max_iterations, second_steps, left});
  if (bounded.max_iterations <= 0) return first;
  ElasticPoint second = attempt(problem, system, bounded, starting_point(problem, second_price), progress);
  second.iterations += first.iterations;
  return second.converged && !falls_short(second) ? second : first;
}

}  // namespace croquis
