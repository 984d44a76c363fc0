// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/solver/least_squares.h"
#include "solver/dense_oracle.h"
#include "solver/sample_problems.h"

using namespace croquis;
using namespace croquis::test;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

LeastSquaresSolution solve(const LeastSquaresProblem& problem) {
  Progress progress;
  return solve_least_squares(problem, {}, progress);
}

Matrix sparse(const Eigen::MatrixXd& dense) { return dense.sparseView(); }

Matrix identity(int n) { return sparse(Eigen::MatrixXd::Identity(n, n)); }

VectorXd vector(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

double largest(const VectorXd& values) { return values.lpNorm<Eigen::Infinity>(); }

/// With matrices that have all their columns, also where there are no rows: what Eigen's products ask for.
LeastSquaresProblem complete(LeastSquaresProblem problem, Eigen::Index unknowns) {
  for (auto* matrix : {&problem.objective, &problem.equalities, &problem.inequalities}) {
    if (matrix->rows() == 0) matrix->resize(0, unknowns);
  }
  return problem;
}

/// Karush, Kuhn and Tucker's conditions, which a convex problem's optimum and nothing else meets.
void check_optimal(const LeastSquaresProblem& given, const LeastSquaresSolution& solution, double tolerance) {
  const LeastSquaresProblem problem = complete(given, solution.x.size());
  CHECK(solution.converged);
  CHECK(solution.violated_rows.empty());
  CHECK(solution.contradictory_equalities.empty());
  const VectorXd slope = problem.objective.transpose() * (problem.objective * solution.x - problem.target);
  const VectorXd forces = problem.inequalities.transpose() * solution.multipliers +
                          problem.equalities.transpose() * solution.equality_multipliers;
  const double force_scale =
      std::max({largest(slope), largest(problem.objective.transpose() * problem.target), 1e-300});
  CHECK(largest(slope - forces) <= tolerance * force_scale);
  const double length_scale = largest(solution.x) + largest(problem.inequality_bounds);
  CHECK(largest(problem.equalities * solution.x - problem.equality_values) <= tolerance * length_scale);
  const VectorXd margin = problem.inequalities * solution.x - problem.inequality_bounds;
  for (Eigen::Index row = 0; row < margin.size(); ++row) {
    CHECK(margin[row] >= -tolerance * length_scale);
    CHECK(solution.multipliers[row] >= 0);
    CHECK(margin[row] * solution.multipliers[row] <= tolerance * length_scale * force_scale);
  }
}

RandomShape shape_of(std::uint32_t seed) {
  const int s = static_cast<int>(seed);
  RandomShape shape;
  shape.unknowns = 2 + s % 9;
  shape.objective_rows = shape.unknowns + s % 5;
  shape.equalities = std::min(s % 4, shape.unknowns - 1);
  shape.inequalities = 3 + s % 17;
  shape.tight = s % shape.inequalities;
  return shape;
}

}  // namespace

TEST_CASE("random problems meet the optimality conditions and agree with a dense active-set method") {
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const LeastSquaresProblem problem = random_problem(shape_of(seed), seed);
    const LeastSquaresSolution solution = solve(problem);
    check_optimal(problem, solution, 1e-9);
    CHECK(solution.iterations <= 25);
    const auto expected = dense_optimum(problem);
    if (!expected) continue;
    CHECK(largest(solution.x - *expected) <= 1e-6 * (1 + largest(*expected)));
    ++compared;
  }
  CHECK(compared >= 390);
}

TEST_CASE("rows nearly parallel to the equalities hold, however strong a force that takes") {
  RandomShape shape;
  shape.unknowns = 13;
  shape.objective_rows = 15;
  shape.equalities = 12;
  shape.inequalities = 2;
  shape.tight = 0;
  const LeastSquaresProblem problem = random_problem(shape, 1026);
  const LeastSquaresSolution solution = solve(problem);
  check_optimal(problem, solution, 1e-9);
  const auto expected = dense_optimum(problem);
  REQUIRE(expected);
  CHECK(largest(solution.x - *expected) <= 1e-6 * (1 + largest(*expected)));
}

TEST_CASE("depths of rings and knots take at most 25 steps and 40 factorisations") {
  for (const auto& [lines, radius] : {std::pair(chain_of_rings(5, 32), 18.0), std::pair(chain_of_rings(2, 96), 18.0),
                                      std::pair(chain_of_rings(16, 64), 18.0), std::pair(trefoil(60), 36.0),
                                      std::pair(trefoil(181), 36.0), std::pair(trefoil(400), 20.0)}) {
    const LeastSquaresProblem problem = depth_problem(lines, radius);
    CAPTURE(problem.objective.cols(), problem.inequalities.rows());
    const LeastSquaresSolution solution = solve(problem);
    check_optimal(problem, solution, 1e-9);
    CHECK(solution.iterations > 0);
    CHECK(solution.iterations <= 25);
    CHECK(solution.factorisations <= 40);
    // Feasible: the elastic form leaves no trace.
    CHECK(largest(solution.shortfall) <= 1e-11 * largest(problem.inequality_bounds));
  }
}

TEST_CASE("sheets over obstacles take at most 25 steps and 40 factorisations") {
  for (const auto& [cells, sheets, share] : {std::tuple(12, 2, 0.3), std::tuple(30, 2, 0.75), std::tuple(24, 3, 0.5),
                                             std::tuple(16, 4, 0.1), std::tuple(40, 2, 0.02)}) {
    CAPTURE(cells, sheets, share);
    const LeastSquaresProblem problem = sheet_problem(cells, sheets, share);
    const LeastSquaresSolution solution = solve(problem);
    check_optimal(problem, solution, 1e-8);
    CHECK(solution.iterations > 0);
    CHECK(solution.iterations <= 25);
    CHECK(solution.factorisations <= 40);
  }
}

TEST_CASE("rows that hold at the equalities' optimum cost one factorisation") {
  LeastSquaresProblem problem = depth_problem(chain_of_rings(2, 32), 18);
  problem.inequality_bounds.setConstant(-1);
  const LeastSquaresSolution solution = solve(problem);
  CHECK(solution.factorisations == 1);
  CHECK(solution.iterations == 0);
  check_optimal(problem, solution, 1e-12);
}

TEST_CASE("one contradictory row planted among rings takes all of the shortfall") {
  LeastSquaresProblem problem = depth_problem(chain_of_rings(3, 32), 18);
  const LeastSquaresSolution before = solve(problem);
  // The opposite of the row that presses most.
  const auto rows = problem.inequalities.rows();
  for (const double gap : {5.0, 20.0, 40.0}) {
    CAPTURE(gap);
    LeastSquaresProblem planted = problem;
    Eigen::MatrixXd dense(rows + 1, problem.inequalities.cols());
    dense.topRows(rows) = Eigen::MatrixXd(problem.inequalities);
    Eigen::Index strongest = 0;
    before.multipliers.maxCoeff(&strongest);
    dense.row(rows) = -dense.row(strongest);
    planted.inequalities = sparse(dense);
    planted.inequality_bounds.conservativeResize(rows + 1);
    planted.inequality_bounds[rows] = gap;
    const LeastSquaresSolution after = solve(planted);
    CHECK(after.converged);
    CHECK(after.iterations <= 25);
    CHECK(after.factorisations <= 40);
    CHECK(std::find(after.violated_rows.begin(), after.violated_rows.end(), static_cast<int>(rows)) !=
          after.violated_rows.end());
    // All of the rows' shortfalls together are what the pair needs, no more.
    CHECK(after.shortfall.sum() == Approx(gap + problem.inequality_bounds[strongest]).epsilon(1e-7));
  }
}

TEST_CASE("random rows that contradict each other converge, and the rows that hold are exact") {
  int contradictory = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    LeastSquaresProblem problem = random_problem(shape_of(seed), seed);
    std::mt19937 random(seed);
    for (double& bound : problem.inequality_bounds)
      if (random() % 3u == 0) bound += static_cast<double>(random() % 1000u) / 100;
    const LeastSquaresSolution solution = solve(problem);
    CHECK(solution.converged);
    CHECK(solution.factorisations <= 45);
    CHECK(solution.primal_residual <= 1e-9);
    CHECK(solution.dual_residual <= 1e-5);
    CHECK(solution.violated_rows.empty() == dense_optimum(problem).has_value());
    contradictory += solution.violated_rows.empty() ? 0 : 1;
  }
  CHECK(contradictory > 100);
}

TEST_CASE("contradicting bounds on one number leave the least sum of shortfalls") {
  // Breakpoints of the sum are the bounds themselves: try all of them.
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    const int rows = 2 + static_cast<int>(random() % 6u);
    Eigen::MatrixXd signs(rows, 1);
    VectorXd bounds(rows);
    for (int row = 0; row < rows; ++row) {
      signs(row, 0) = random() % 2u == 0 ? 1 : -1;
      bounds[row] = static_cast<double>(random() % 1000u) / 100 - 3;
    }
    LeastSquaresProblem problem;
    problem.objective = identity(1);
    problem.target = vector({static_cast<double>(random() % 1000u) / 100 - 5});
    problem.inequalities = sparse(signs);
    problem.inequality_bounds = bounds;
    const auto cost = [&](double x) { return (bounds - signs * x).cwiseMax(0.0).sum(); };
    std::vector<double> places{problem.target[0]};
    for (int row = 0; row < rows; ++row) places.push_back(signs(row, 0) * bounds[row]);
    double least = std::numeric_limits<double>::infinity();
    for (const double place : places) least = std::min(least, cost(place));
    double nearest = std::numeric_limits<double>::infinity();
    for (const double place : places)
      if (cost(place) <= least + 1e-12) nearest = std::min(nearest, std::abs(place - problem.target[0]));
    const LeastSquaresSolution solution = solve(problem);
    CHECK(solution.converged);
    CHECK(solution.shortfall.sum() == Approx(least).margin(1e-9));
    CHECK(std::abs(solution.x[0] - problem.target[0]) == Approx(nearest).margin(1e-7));
    CHECK(solution.violated_rows.empty() == (least < 1e-9));
  }
}

TEST_CASE("problems without inequalities, equalities, objective or unknowns are solved") {
  LeastSquaresProblem problem;
  CHECK(solve(problem).x.size() == 0);

  problem.objective = identity(2);
  problem.target = vector({1, 2});
  CHECK(largest(solve(problem).x - vector({1, 2})) <= 1e-15);

  problem.inequalities = identity(2);
  problem.inequality_bounds = vector({3, -1});
  CHECK(largest(solve(problem).x - vector({3, 2})) <= 1e-12);

  LeastSquaresProblem no_objective;
  no_objective.equalities = sparse(Eigen::MatrixXd::Ones(1, 2));
  no_objective.equality_values = vector({4});
  no_objective.inequalities = sparse((Eigen::MatrixXd(1, 2) << 1, -1).finished());
  no_objective.inequality_bounds = vector({2});
  const LeastSquaresSolution solution = solve(no_objective);
  CHECK(solution.singular_objective);
  CHECK(solution.violated_rows.empty());
  CHECK(solution.x.sum() == Approx(4));
  CHECK(solution.x[0] - solution.x[1] >= 2 - 1e-7);

  LeastSquaresProblem bounds_alone;
  bounds_alone.inequalities = identity(2);
  bounds_alone.inequality_bounds = vector({3, -1});
  const LeastSquaresSolution corner = solve(bounds_alone);
  CHECK(corner.violated_rows.empty());
  CHECK(corner.x[0] >= 3 - 1e-6);
}

TEST_CASE("rows without entries are met or named") {
  LeastSquaresProblem problem;
  problem.objective = identity(2);
  problem.target = vector({0, 0});
  problem.equalities = Matrix(2, 2);
  problem.equality_values = vector({0, 1});
  problem.inequalities = sparse((Eigen::MatrixXd(3, 2) << 0, 0, 1, 0, 0, 0).finished());
  problem.inequality_bounds = vector({5, 2, -5});
  const LeastSquaresSolution solution = solve(problem);
  CHECK(solution.contradictory_equalities == std::vector<int>{1});
  CHECK(solution.violated_rows == std::vector<int>{0});
  CHECK(solution.shortfall[0] == 5);
  CHECK(largest(solution.x - vector({2, 0})) <= 1e-9);
}

TEST_CASE("bounds that no point comes near change nothing") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const LeastSquaresProblem problem = random_problem(shape_of(seed), seed);
    LeastSquaresProblem loose = problem;
    const Eigen::Index rows = problem.inequalities.rows();
    Eigen::MatrixXd twice(2 * rows, problem.inequalities.cols());
    twice << Eigen::MatrixXd(problem.inequalities), -Eigen::MatrixXd(problem.inequalities);
    loose.inequalities = sparse(twice);
    loose.inequality_bounds.conservativeResize(2 * rows);
    for (Eigen::Index row = 0; row < rows; ++row) loose.inequality_bounds[rows + row] = row % 2 == 0 ? -1e15 : -1e30;
    const LeastSquaresSolution solution = solve(loose);
    CHECK(solution.converged);
    CHECK(solution.violated_rows.empty());
    CHECK(solution.iterations <= 25);
    CHECK(largest(solution.x - solve(problem).x) <= 1e-8 * (1 + largest(solution.x)));
  }
}

TEST_CASE("rows and unknowns in wildly mixed units give the same answer") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const LeastSquaresProblem problem = random_problem(shape_of(seed), seed);
    std::mt19937 random(seed);
    const auto factors = [&random](Eigen::Index size) {
      VectorXd values(size);
      for (double& value : values) value = std::pow(10.0, static_cast<double>(random() % 121u) / 10 - 6);
      return values;
    };
    const VectorXd columns = factors(problem.objective.cols());
    const VectorXd equality_rows = factors(problem.equalities.rows());
    const VectorXd rows = factors(problem.inequalities.rows());
    LeastSquaresProblem mixed = problem;
    mixed.objective = problem.objective * columns.asDiagonal();
    mixed.equalities = equality_rows.asDiagonal() * Matrix(problem.equalities * columns.asDiagonal());
    mixed.equality_values = equality_rows.cwiseProduct(problem.equality_values);
    mixed.inequalities = rows.asDiagonal() * Matrix(problem.inequalities * columns.asDiagonal());
    mixed.inequality_bounds = rows.cwiseProduct(problem.inequality_bounds);
    const LeastSquaresSolution reference = solve(problem);
    const LeastSquaresSolution solution = solve(mixed);
    CHECK(solution.converged);
    CHECK(solution.violated_rows.empty());
    // Prices per unit of such rows differ by 1e4, which costs some steps.
    CHECK(solution.iterations <= 40);
    CHECK(largest(columns.cwiseProduct(solution.x) - reference.x) <= 1e-7 * (1 + largest(reference.x)));
  }
}

TEST_CASE("dependent equalities change nothing") {
  for (std::uint32_t seed = 1; seed < 60; ++seed) {
    CAPTURE(seed);
    const LeastSquaresProblem problem = random_problem(shape_of(seed), seed);
    const Eigen::MatrixXd once = problem.equalities;
    if (once.rows() == 0) continue;
    Eigen::MatrixXd thrice(3 * once.rows(), once.cols());
    thrice << once, -2 * once, once.colwise().sum().replicate(once.rows(), 1);
    LeastSquaresProblem repeated = problem;
    repeated.equalities = sparse(thrice);
    repeated.equality_values = VectorXd(thrice.rows());
    repeated.equality_values << problem.equality_values, -2 * problem.equality_values,
        VectorXd::Constant(once.rows(), problem.equality_values.sum());
    const LeastSquaresSolution solution = solve(repeated);
    check_optimal(repeated, solution, 1e-8);
    CHECK(largest(solution.x - solve(problem).x) <= 1e-7 * (1 + largest(solution.x)));
  }
}

TEST_CASE("equalities that contradict each other are named, and no other") {
  LeastSquaresProblem problem;
  problem.objective = identity(3);
  problem.target = vector({1, 1, 1});
  problem.equalities = sparse((Eigen::MatrixXd(4, 3) << 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0).finished());
  problem.equality_values = vector({2, 0, 5, 4});
  problem.inequalities = sparse((Eigen::MatrixXd(1, 3) << 0, 1, 0).finished());
  problem.inequality_bounds = vector({1});
  const LeastSquaresSolution solution = solve(problem);
  CHECK(solution.contradictory_equalities == std::vector<int>{1, 3});
  CHECK(solution.violated_rows.empty());
  CHECK(largest(solution.x - vector({2, 3, 2})) <= 1e-6);
}

TEST_CASE("an objective blind to a direction is known from one that sees all") {
  LeastSquaresProblem problem;
  problem.objective = sparse((Eigen::MatrixXd(2, 3) << 1, -1, 0, 0, 1, -1).finished());
  problem.target = vector({1, 1});
  const LeastSquaresSolution free_shift = solve(problem);
  CHECK(free_shift.singular_objective);
  CHECK(free_shift.x[0] - free_shift.x[2] == Approx(2));
  problem.equalities = sparse((Eigen::MatrixXd(1, 3) << 1, 1, 1).finished());
  CHECK_FALSE(solve(problem).singular_objective);
  CHECK_FALSE(solve(depth_problem(trefoil(181), 36)).singular_objective);
  CHECK_FALSE(solve(sheet_problem(60, 1, 0)).singular_objective);
}

TEST_CASE("numbers that are not finite and sizes that don't fit are refused, all at once") {
  LeastSquaresProblem problem;
  problem.objective = identity(2);
  problem.target = vector({1, std::numeric_limits<double>::quiet_NaN()});
  problem.equalities = identity(3);
  problem.inequalities = identity(2);
  problem.inequality_bounds = vector({1, 2, std::numeric_limits<double>::infinity()});
  try {
    solve(problem);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.findings().size() >= 4);
    for (const Finding& finding : error.findings()) CHECK(finding.code == "E_SOLVER");
  }
}

TEST_CASE("a raised cancel flag stops the solver") {
  std::atomic<bool> cancel{true};
  Progress before({}, &cancel);
  const LeastSquaresProblem problem = depth_problem(chain_of_rings(3, 48), 18);
  CHECK_THROWS_AS(solve_least_squares(problem, {}, before), Cancelled);

  cancel = false;
  int reports = 0;
  Progress during([&](double, const std::string&) { cancel = ++reports == 4; }, &cancel);
  CHECK_THROWS_AS(solve_least_squares(problem, {}, during), Cancelled);
  CHECK(reports <= 5);
}

TEST_CASE("progress rises to 1") {
  std::vector<double> seen;
  Progress progress([&](double fraction, const std::string&) { seen.push_back(fraction); });
  solve_least_squares(depth_problem(chain_of_rings(3, 48), 18), {}, progress);
  CHECK(seen.size() > 5);
  CHECK(std::is_sorted(seen.begin(), seen.end()));
  CHECK(seen.back() == 1);
}

TEST_CASE("a body that is held a hundred billion times more softly than it bends is placed as exactly as others") {
  constexpr int nodes = 20;
  constexpr double stiffness = 1e5;
  const double pulls[] = {1, 2};
  LeastSquaresProblem problem;
  std::vector<Eigen::Triplet<double>> objective;
  int row = 0;
  for (int body = 0; body < 2; ++body) {
    objective.emplace_back(row++, body * nodes, pulls[body]);
    for (int i = 0; i + 1 < nodes; ++i, ++row) {
      objective.emplace_back(row, body * nodes + i, -stiffness);
      objective.emplace_back(row, body * nodes + i + 1, stiffness);
    }
  }
  problem.objective.resize(row, 2 * nodes);
  problem.objective.setFromTriplets(objective.begin(), objective.end());
  std::vector<Eigen::Triplet<double>> apart;
  for (int i = 5; i < 15; ++i) {
    apart.emplace_back(i - 5, i, 1.0);
    apart.emplace_back(i - 5, nodes + i, -1.0);
  }
  problem.inequalities.resize(10, 2 * nodes);
  problem.inequalities.setFromTriplets(apart.begin(), apart.end());
  problem.inequality_bounds = VectorXd::Ones(10);

  const LeastSquaresSolution solution = solve(problem);
  CHECK(solution.converged);
  CHECK(!solution.singular_objective);
  CHECK(solution.iterations <= 25);
  CHECK(largest(solution.remaining_step) <= 1e-6);
  // Rigid bodies: pushed apart by one force, each gives way as the square of its pull lets it.
  for (int i = 0; i < nodes; ++i) {
    CHECK(solution.x[i] == Approx(0.8).margin(1e-6));
    CHECK(solution.x[nodes + i] == Approx(-0.2).margin(1e-6));
  }
}

TEST_CASE("what is left to go is reported, and is nothing where the optimum is known") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    RandomShape shape;
    shape.unknowns = 3 + static_cast<int>(seed % 6);
    shape.objective_rows = shape.unknowns + 3;
    const LeastSquaresProblem problem = random_problem(shape, seed);
    const LeastSquaresSolution solution = solve(problem);
    REQUIRE(solution.remaining_step.size() == solution.x.size());
    CHECK(largest(solution.remaining_step) <= 1e-7 * (1 + largest(solution.x)));
    LeastSquaresOptions hurried;
    hurried.max_iterations = 1;
    Progress progress;
    const LeastSquaresSolution early = solve_least_squares(problem, hurried, progress);
    CHECK((!early.converged || largest(early.remaining_step) <= 1e-7 * (1 + largest(early.x))));
  }
}
