// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// minimise Σ cost x  subject to  lower <= A x <= upper for every row, bounds on x, x integer.
class IntegerProgram {
 public:
  struct Term {
    Index variable = 0;
    double factor = 0;
  };

  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  /// @returns the variable's index
  Index add_variable(double lower, double upper, double cost);
  void add_row(std::vector<Term> terms, double lower, double upper);

  void set_bounds(Index variable, double lower, double upper);
  void fix(Index variable, double value) { set_bounds(variable, value, value); }

  Index variable_count() const { return static_cast<Index>(variables_.size()); }

  enum class Status { Optimal, Infeasible, Limit };

  struct Solution {
    Status status = Status::Infeasible;
    std::vector<int> values;  ///< of Limit: the best known, or empty
    int nodes = 0;            ///< branches looked at
  };

  /// Branch and bound by GLPK, in a thread of its own: GLPK's environment belongs to the thread, so it can be thrown
  /// away, after an error too, without losing other problems. Prints nothing; bounds are counts. Variables that no rows
  /// connect are solved for apart: together their branches would multiply.
  /// @param gap   solutions that may be better by this share at most count as optimal
  /// @param first variables before this one are branched on first: those that the others follow from
  /// @throws Error (E_INTERNAL) when GLPK refuses the problem
  Solution solve(int maximum_nodes, double gap = 0, Index first = 0) const;

 private:
  struct Part;
  std::vector<Part> parts() const;
  std::optional<int> free_value() const;
  Solution solve_connected(int maximum_nodes, double gap, Index first) const;

  struct Variable {
    double lower, upper, cost;
  };
  struct Row {
    std::vector<Term> terms;
    double lower, upper;
  };

  std::vector<Variable> variables_;
  std::vector<Row> rows_;
};

}  // namespace croquis
