// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace croquis {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

/// First penalty per unit of shortfall, where an unknown's own curvature and the largest violation are 1.
constexpr double first_penalty = 1e2;
/// The penalty is raised while it is below this multiple of the largest multiplier: the margin that makes it exact.
constexpr double penalty_margin = 10;
constexpr double penalty_growth = 1e2;
/// Rows that contradict each other take any price, so raising has to end: 1e2 * 1e2^2 leaves 10 digits for the rest.
constexpr int most_raises = 2;
/// Part of the way to the nearest bound that a step may go; approaches 1 as the products approach 0.
constexpr double shortest_reach = 0.9;
constexpr int refinements = 2;

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
  Run(const ElasticProblem& problem, KktSystem& system) : problem_(problem), system_(system) { start(); }

  bool converged(const LeastSquaresOptions& options);
  void raise_penalty();
  void iterate();

  ElasticPoint point;

 private:
  void start();
  double mean_product() const;
  Step direction(const VectorXd& distance_target, const VectorXd& shortfall_target) const;
  double reach(const Step& step) const;
  void move(const Step& step, double length);

  const ScaledProblem& matrices() const { return *problem_.matrices; }

  const ElasticProblem& problem_;
  KktSystem& system_;
  Residuals residuals_;
  VectorXd row_weights_;
  int raises_ = 0;
};

/// Each row starts with a distance of at least 1 (the largest violation) and a multiplier to match; the shortfall
/// starts small, since most rows need none.
void Run::start() {
  const Index rows = problem_.bounds.size();
  point.penalty = first_penalty;
  point.y = VectorXd::Zero(system_.unknowns());
  point.equality = VectorXd::Zero(matrices().equalities.rows());
  point.distance = (-problem_.bounds).cwiseMax(1.0);
  point.multipliers = point.distance.cwiseInverse().cwiseMin(0.5 * point.penalty * problem_.prices);
  point.slack_multipliers = point.penalty * problem_.prices - point.multipliers;
  point.shortfall = point.slack_multipliers.cwiseInverse();
  row_weights_.resize(rows);
}

double Run::mean_product() const {
  const double sum = point.distance.dot(point.multipliers) + point.shortfall.dot(point.slack_multipliers);
  return sum / static_cast<double>(2 * point.distance.size());
}

bool Run::converged(const LeastSquaresOptions& options) {
  const ScaledProblem& m = matrices();
  residuals_.stationarity = m.inequalities.transpose() * point.multipliers + m.equalities.transpose() * point.equality -
                            m.objective.transpose() * (m.objective * point.y);
  residuals_.equality = -(m.equalities * point.y);
  residuals_.rows = problem_.bounds - m.inequalities * point.y - point.shortfall + point.distance;
  const double multiplier_scale = std::max(1.0, point.multipliers.lpNorm<Eigen::Infinity>());
  return residuals_.rows.lpNorm<Eigen::Infinity>() <= options.primal_tolerance &&
         residuals_.equality.lpNorm<Eigen::Infinity>() <= options.primal_tolerance &&
         residuals_.stationarity.lpNorm<Eigen::Infinity>() <= options.primal_tolerance * multiplier_scale &&
         mean_product() <= options.complementarity_tolerance;
}

/// Raising the price of shortfalls adds to mu alone and leaves the stationarity untouched.
void Run::raise_penalty() {
  const double largest = point.multipliers.cwiseQuotient(problem_.prices).maxCoeff();
  if (raises_ == most_raises || point.penalty >= penalty_margin * largest) return;
  ++raises_;
  const double raised = point.penalty * penalty_growth;
  point.slack_multipliers += (raised - point.penalty) * problem_.prices;
  point.penalty = raised;
}

/// Newton's direction for w lambda -> distance_target and s mu -> shortfall_target (the targets hold second-order
/// terms).
Step Run::direction(const VectorXd& distance_target, const VectorXd& shortfall_target) const {
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

/// The longest step in [0, 1/shortest_reach] that keeps `values` >= 0.
double longest(const VectorXd& values, const VectorXd& change) {
  double length = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < values.size(); ++i)
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

void Run::iterate() {
  row_weights_ =
      (point.distance.array() / point.multipliers.array() + point.shortfall.array() / point.slack_multipliers.array())
          .inverse();
  system_.factorise(row_weights_);

  // Predictor: straight for the optimum. How far it gets tells how much centring the corrector needs.
  const Index rows = problem_.bounds.size();
  const VectorXd none = VectorXd::Zero(rows);
  const Step predictor = direction(none, none);
  const double length = std::min(1.0, reach(predictor));
  const double mean = mean_product();
  const VectorXd distance = point.distance + length * predictor.distance;
  const VectorXd shortfall = point.shortfall + length * predictor.shortfall;
  const VectorXd multipliers = point.multipliers + length * predictor.multipliers;
  const VectorXd slack_multipliers = point.slack_multipliers - length * predictor.multipliers;
  const double predicted =
      (distance.dot(multipliers) + shortfall.dot(slack_multipliers)) / static_cast<double>(2 * rows);
  const double centring = std::pow(std::clamp(predicted / mean, 0.0, 1.0), 3);

  // Corrector: towards equal products, with the predictor's second-order error taken out.
  const VectorXd target = VectorXd::Constant(rows, centring * mean);
  const Step corrector = direction(target - predictor.distance.cwiseProduct(predictor.multipliers),
                                   target + predictor.shortfall.cwiseProduct(predictor.multipliers));
  const double caution = std::max(shortest_reach, 1 - mean);
  move(corrector, std::min(1.0, caution * reach(corrector)));
  ++point.iterations;
}

}  // namespace

ElasticPoint run_interior_point(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                Progress& progress) {
  Run run(problem, system);
  while (!(run.point.converged = run.converged(options)) && run.point.iterations < options.max_iterations) {
    progress.check();
    run.iterate();
    run.raise_penalty();
    // The number of steps isn't known beforehand: each takes a part of what is left.
    progress.report(1 - std::pow(0.85, run.point.iterations));
  }
  return run.point;
}

}  // namespace croquis
