// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace croquis {

inline constexpr int largest_small_fit = 6;

/// J^T J and J^T r of up to six unknowns; no memory is taken from the heap.
struct NormalEquations {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, largest_small_fit, largest_small_fit>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, largest_small_fit, 1>;

  Matrix matrix;
  Vector gradient;

  explicit NormalEquations(Eigen::Index unknowns)
      : matrix(Matrix::Zero(unknowns, unknowns)), gradient(Vector::Zero(unknowns)) {}

  void add(const Vector& row, double residual, double weight = 1) {
    matrix.noalias() += weight * row * row.transpose();
    gradient.noalias() += weight * residual * row;
  }
};

/// Costs are flat at their bottom, where their digits no longer show what is better; plain steps still lead on.
template <typename State, typename Cost, typename Evaluate, typename Moved>
double polished(State& state, double best, Eigen::Index unknowns, const Cost& cost, const Evaluate& evaluate,
                const Moved& moved) {
  constexpr int steps = 6;
  constexpr double tolerated = 1e-12;  // relative growth of the cost
  for (int i = 0; i < steps; ++i) {
    NormalEquations equations(unknowns);
    evaluate(state, equations);
    const NormalEquations::Vector step = -equations.matrix.ldlt().solve(equations.gradient);
    if (!step.allFinite()) return best;
    const State trial = moved(state, step);
    const double next = cost(trial);
    if (!(next <= best * (1 + tolerated))) return best;
    state = trial;
    best = std::min(best, next);
  }
  return best;
}

/// Least squares over a small state (Levenberg 1944, Marquardt 1963).
/// @param cost     (const State&) -> double
/// @param evaluate (const State&, NormalEquations&) -> void, of half the cost's gradient
/// @param moved    (const State&, const NormalEquations::Vector&) -> State
/// @return the last cost
template <typename State, typename Cost, typename Evaluate, typename Moved>
double levenberg_marquardt(State& state, Eigen::Index unknowns, const Cost& cost, const Evaluate& evaluate,
                           const Moved& moved, int rounds = 60) {
  constexpr double settled = 1e-12;      // relative change of the cost
  constexpr double most_damping = 1e12;  // beyond this no step leads down
  double best = cost(state);
  double damping = 1e-4;
  int settled_rounds = 0;
  for (int round = 0; round < rounds && settled_rounds < 2; ++round) {
    NormalEquations equations(unknowns);
    evaluate(state, equations);
    double next = best;
    for (; damping < most_damping; damping *= 8) {
      NormalEquations::Matrix damped = equations.matrix;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-300;
      const NormalEquations::Vector step = -damped.ldlt().solve(equations.gradient);
      if (!step.allFinite()) continue;
      const State trial = moved(state, step);
      next = cost(trial);
      if (!(next <= best)) continue;
      state = trial;
      break;
    }
    if (damping >= most_damping) break;
    settled_rounds = best - next <= settled * best ? settled_rounds + 1 : 0;
    best = next;
    damping = damping > 1e-14 ? damping / 10 : damping;
  }
  return polished(state, best, unknowns, cost, evaluate, moved);
}

}  // namespace croquis
