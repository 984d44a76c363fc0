// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/solver/integer_program.h"
#include "support/random.h"

using namespace croquis;

TEST_CASE("an integer program is solved to its optimum, not to the rounded relaxation") {
  // max 5x + 4y, 6x + 4y <= 24, x + 2y <= 6: relaxed (3, 1.5), integer (4, 0).
  IntegerProgram program;
  const Index x = program.add_variable(0, 10, -5);
  const Index y = program.add_variable(0, 10, -4);
  program.add_row({{x, 6}, {y, 4}}, -IntegerProgram::unbounded, 24);
  program.add_row({{x, 1}, {y, 2}}, -IntegerProgram::unbounded, 6);
  const auto solution = program.solve(100);
  REQUIRE(solution.status == IntegerProgram::Status::Optimal);
  CHECK(solution.values == std::vector<int>{4, 0});
}

TEST_CASE("small integer programs agree with trying everything") {
  test::Random random(21);
  for (int round = 0; round < 40; ++round) {
    IntegerProgram program;
    std::vector<double> cost;
    for (int i = 0; i < 4; ++i) {
      cost.push_back(static_cast<double>(random.below(9)) - 4);
      program.add_variable(0, 3, cost.back());
    }
    std::vector<std::vector<double>> rows;
    for (int r = 0; r < 3; ++r) {
      rows.emplace_back();
      std::vector<IntegerProgram::Term> terms;
      for (Index i = 0; i < 4; ++i) {
        rows.back().push_back(static_cast<double>(random.below(7)) - 3);
        terms.push_back({i, rows.back().back()});
      }
      program.add_row(terms, -2, 3);
    }
    double best = std::numeric_limits<double>::infinity();
    for (int code = 0; code < 256; ++code) {
      const std::vector<int> v{code & 3, (code >> 2) & 3, (code >> 4) & 3, (code >> 6) & 3};
      bool feasible = true;
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i) value += cost[i] * v[i];
      for (const std::vector<double>& row : rows) {
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) sum += row[i] * v[i];
        feasible = feasible && sum >= -2 && sum <= 3;
      }
      if (feasible) best = std::min(best, value);
    }
    const auto solution = program.solve(10'000);
    REQUIRE(solution.status == IntegerProgram::Status::Optimal);
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value += cost[i] * solution.values[i];
    CHECK(value == Approx(best));
  }
}

TEST_CASE("while each solution is excluded all of them come, the cheapest first") {
  test::Random random(22);
  for (int round = 0; round < 30; ++round) {
    constexpr int count = 7;
    IntegerProgram program;
    std::vector<double> cost;
    for (int i = 0; i < count; ++i) {
      cost.push_back(static_cast<double>(random.below(9)) - 4);
      program.add_variable(0, 1, cost.back());
    }
    std::vector<std::vector<int>> rows;
    for (int r = 0; r < 3; ++r) {
      rows.emplace_back();
      std::vector<IntegerProgram::Term> terms;
      for (Index i = 0; i < count; ++i) {
        rows.back().push_back(static_cast<int>(random.below(5)) - 2);
        if (rows.back().back() != 0) terms.push_back({i, static_cast<double>(rows.back().back())});
      }
      program.add_row(terms, -1, 2);
    }
    std::vector<double> expected;
    for (int code = 0; code < 1 << count; ++code) {
      double value = 0;
      const auto taken = [&](int i) { return (code >> i) & 1; };
      for (int i = 0; i < count; ++i) value += cost[static_cast<std::size_t>(i)] * taken(i);
      const bool feasible = std::ranges::all_of(rows, [&](const std::vector<int>& row) {
        int sum = 0;
        for (int i = 0; i < count; ++i) sum += row[static_cast<std::size_t>(i)] * taken(i);
        return sum >= -1 && sum <= 2;
      });
      if (feasible) expected.push_back(value);
    }
    std::ranges::sort(expected);
    std::vector<double> found;
    for (auto solution = program.solve(1000); !solution.values.empty(); solution = program.solve(1000)) {
      REQUIRE(solution.status == IntegerProgram::Status::Optimal);
      double value = 0, ones = 0;
      std::vector<IntegerProgram::Term> same;
      for (Index i = 0; i < count; ++i) {
        value += cost[i] * solution.values[i];
        ones += solution.values[i];
        same.push_back({i, solution.values[i] == 1 ? 1.0 : -1.0});
      }
      found.push_back(value);
      program.add_row(std::move(same), -IntegerProgram::unbounded, ones - 1);
    }
    CHECK(program.solve(1000).status == IntegerProgram::Status::Infeasible);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-9));
  }
}

TEST_CASE("after a change of bounds the search begins anew") {
  IntegerProgram program;
  const Index x = program.add_variable(0, 3, 1);
  const Index y = program.add_variable(0, 3, 2);
  program.add_row({{x, 1}, {y, 1}}, 3, 5);
  CHECK(program.solve(100).values == std::vector<int>{3, 0});
  program.set_bounds(x, 0, 1);
  CHECK(program.solve(100).values == std::vector<int>{1, 2});
  program.set_bounds(x, 0, 3);
  CHECK(program.solve(100).values == std::vector<int>{3, 0});
}

TEST_CASE("contradicting rows are infeasible") {
  IntegerProgram program;
  const Index x = program.add_variable(0, 1, 1);
  program.add_row({{x, 2}}, 1, 1);
  CHECK(program.solve(100).status == IntegerProgram::Status::Infeasible);
}

TEST_CASE("a bound on nodes ends the search") {
  // Parity: an even sum can't be odd, but the relaxation can't see it.
  IntegerProgram program;
  std::vector<IntegerProgram::Term> terms;
  for (int i = 0; i < 30; ++i) terms.push_back({program.add_variable(0, 1, 0), 2});
  program.add_row(terms, 29, 29);
  CHECK(program.solve(20).status == IntegerProgram::Status::Limit);
}

TEST_CASE("a problem that GLPK refuses is an error, and the next one is solved") {
  IntegerProgram bad;
  bad.add_variable(1, 0, 1);  // bounds the wrong way round
  bad.add_row({{0, 1}}, std::numeric_limits<double>::quiet_NaN(), 1);
  bad.add_row({{7, 1}}, 0, 1);  // no such variable
  CHECK_THROWS_AS(bad.solve(10), Error);
  IntegerProgram good;
  good.add_variable(2, 5, 1);
  CHECK(good.solve(10).values == std::vector<int>{2});
}

TEST_CASE("integer programs can be solved by several threads at once") {
  std::vector<int> results(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) {
    threads.emplace_back([&results, i] {
      for (int k = 0; k < 20; ++k) {
        IntegerProgram program;
        program.add_variable(static_cast<double>(i), 9, 1);
        results[i] += program.solve(10).values.front();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < results.size(); ++i) CHECK(results[i] == 20 * static_cast<int>(i));
}
