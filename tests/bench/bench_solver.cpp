// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ctime>
#include <iomanip>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>

#include "bench/bench.h"
#include "croquis/solver/least_squares.h"
#include "solver/sample_problems.h"

namespace croquis::bench {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Processor time, not the clock's: the solver has one thread, and a busy machine stretches long runs more than short.
template <typename Work>
double median_cpu_ms(int runs, Work&& work) {
  std::vector<double> times;
  for (int run = 0; run <= runs; ++run) {
    const std::clock_t began = std::clock();
    work();
    if (run > 0) times.push_back(1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The lower triangle of [[U^T U + G^T G + dI, E^T], [E, -dI]]: what every step of the solver factorises, built by
/// plain sparse products.
Matrix step_matrix(const LeastSquaresProblem& problem) {
  const Matrix hessian = Matrix(problem.objective.transpose() * problem.objective) +
                         Matrix(problem.inequalities.transpose() * problem.inequalities);
  const int unknowns = static_cast<int>(hessian.cols());
  const int size = unknowns + static_cast<int>(problem.equalities.rows());
  const double regularisation = 1e-10 * hessian.diagonal().maxCoeff();
  Triplets entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i < unknowns ? regularisation : -regularisation);
  for (int column = 0; column < unknowns; ++column) {
    for (Matrix::InnerIterator entry(hessian, column); entry; ++entry)
      if (entry.row() >= column) entries.emplace_back(static_cast<int>(entry.row()), column, entry.value());
    if (problem.equalities.rows() == 0) continue;
    for (Matrix::InnerIterator entry(problem.equalities, column); entry; ++entry)
      entries.emplace_back(unknowns + static_cast<int>(entry.row()), column, entry.value());
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double factorisation_ms(const LeastSquaresProblem& problem) {
  const Matrix matrix = step_matrix(problem);
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> factors;
  factors.analyzePattern(matrix);
  return median_cpu_ms(9, [&] { factors.factorize(matrix); });
}

void bench_one(std::ostream& out, const std::string& name, const LeastSquaresProblem& problem) {
  LeastSquaresSolution solution;
  const double total = median_cpu_ms(3, [&] {
    Progress progress;
    solution = solve_least_squares(problem, {}, progress);
  });
  const double one = factorisation_ms(problem);
  out << "| " << name << " | " << problem.objective.cols() << " | " << problem.equalities.rows() << " | "
      << problem.inequalities.rows() << " | " << solution.iterations << " | " << solution.factorisations << " | "
      << std::fixed << std::setprecision(1) << total << " | " << std::setprecision(2) << one << " | "
      << std::setprecision(1) << total / one << " | " << std::setprecision(2)
      << total / one / std::max(1, solution.factorisations) << " |" << std::endl;
}

}  // namespace

void bench_solver(std::ostream& out) {
  using namespace croquis::test;
  out << "Peer: one numeric factorisation of a step's matrix by Eigen's SimplicialLDLT (AMD), pattern analysed "
         "before.\n"
      << "The solver's time includes scaling, pattern, ordering and polishing.\n\n"
      << "| problem | unknowns | equalities | inequalities | steps | factorisations | total ms | one ms | total / one "
         "| per factorisation / one |\n|---|---|---|---|---|---|---|---|---|---|\n";
  bench_one(out, "rings, decimated", depth_problem(chain_of_rings(5, 32), 18));
  bench_one(out, "rings, all nodes", depth_problem(chain_of_rings(5, 192), 18));
  bench_one(out, "trefoil, decimated", depth_problem(trefoil(181), 20));
  bench_one(out, "trefoil, all nodes", depth_problem(trefoil(1110), 20));
  bench_one(out, "sheets at rest", sheet_problem(70, 2, 0));
  for (const int cells : {20, 40, 70}) bench_one(out, "two sheets", sheet_problem(cells, 2, 0.3));
  bench_one(out, "three sheets", sheet_problem(40, 3, 0.5));
  bench_one(out, "long strip of sheets", sheet_strip(300, 15, 2, 0.3));
}

}  // namespace croquis::bench
