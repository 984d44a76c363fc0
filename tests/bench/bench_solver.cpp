// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iomanip>
#include <string>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/factorisation_peer.h"
#include "croquis/solver/least_squares.h"
#include "solver/sample_problems.h"

namespace croquis::bench {
namespace {

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
