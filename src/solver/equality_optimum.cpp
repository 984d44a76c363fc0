// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/equality_optimum.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace croquis {
namespace {

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

}  // namespace

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

}  // namespace croquis
