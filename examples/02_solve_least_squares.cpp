// SPDX-License-Identifier: GPL-3.0-or-later
// A rope of five knots, ends held at 0 and 1, that must stay above 0.8 in the middle and is otherwise as straight as
// can be. A second request that contradicts the first is not an error: the solver names it.
#include <iostream>

#include "croquis/solver/least_squares.h"

int main() {
  using namespace croquis;
  LeastSquaresProblem rope;
  rope.objective.resize(3, 5);  // second differences: bending
  for (int i = 0; i < 3; ++i) {
    rope.objective.insert(i, i) = 1;
    rope.objective.insert(i, i + 1) = -2;
    rope.objective.insert(i, i + 2) = 1;
  }
  rope.equalities.resize(2, 5);
  rope.equalities.insert(0, 0) = 1;
  rope.equalities.insert(1, 4) = 1;
  rope.equality_values = Eigen::Vector2d(0, 1);
  rope.inequalities.resize(2, 5);
  rope.inequalities.insert(0, 2) = 1;   // x2 >= 0.8
  rope.inequalities.insert(1, 2) = -1;  // x2 <= 0.9
  rope.inequality_bounds = Eigen::Vector2d(0.8, -0.9);

  Progress progress;
  const LeastSquaresSolution bent = solve_least_squares(rope, {}, progress);
  std::cout << "knots: " << bent.x.transpose() << "\n";

  rope.inequality_bounds(1) = -0.7;  // now at most 0.7: impossible together with at least 0.8
  const LeastSquaresSolution torn = solve_least_squares(rope, {}, progress);
  std::cout << "rows that can't hold:";
  for (const int row : torn.violated_rows) std::cout << " " << row;
  std::cout << "\n";
  return bent.violated_rows.empty() && !torn.violated_rows.empty() ? 0 : 1;
}
