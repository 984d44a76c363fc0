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

  Index variable_count() const { return static_cast<Index>(cost_.size()); }

  enum class Status { Optimal, Infeasible, Limit };

  struct Solution {
    Status status = Status::Infeasible;
    std::vector<int> values;  ///< of Limit: the best known, or empty
    int nodes = 0;            ///< branches looked at
    double cost = 0;          ///< of the values
  };

  /// Branch and bound, the most promising branch first, over relaxations that GLPK solves. When rows are added after
  /// it, the next search goes on where this one ended: the k best solutions are found by excluding each in turn, at
  /// little more than what one costs. Variables that no rows connect are solved for apart: together their branches
  /// would multiply. Prints nothing; bounds are counts.
  /// @param maximum_nodes branches to look at
  /// @param gap   solutions that may be better by this share at most count as optimal
  /// @param first variables before this one are branched on first: those that the others follow from
  /// @throws Error (E_INTERNAL) when GLPK refuses the problem
  Solution solve(int maximum_nodes, double gap = 0, Index first = 0);

 private:
  struct Row {
    std::vector<Term> terms;
    double lower, upper;
  };
  struct Bounds {
    double lower, upper;
  };

  /// What is left to search: all solutions within some bounds.
  struct Node {
    double cost = -unbounded;  ///< they cost at least that
    std::vector<Bounds> bounds;
    std::vector<int> basis;   ///< to start from: statuses of rows and variables as GLPK numbers them; or empty
    std::vector<int> values;  ///< of the relaxation where they are whole; else empty
    std::size_t rows = 0;     ///< that were known then
  };

  /// Variables that rows connect.
  struct Part {
    std::vector<Index> variables;  ///< ascending
    std::vector<double> cost;
    std::vector<Row> rows;   ///< their variables as positions in the part
    std::vector<Node> open;  ///< the one added last is the deepest
  };

  class Relaxation;

  void find_parts();
  void add_to_part(const Row& row);
  static std::optional<int> free_value(const Part& part);
  static std::size_t most_promising(const Part& part, double gap);
  static bool is_solution(const Part& part, const Node& node);
  static const Node* best_known(const Part& part);
  static std::optional<Solution> outcome(const Part& part, double gap, bool is_over);
  static void branch(Part& part, Node node, Relaxation& relaxation, Index first);
  static Solution solve_part(Part& part, int maximum_nodes, double gap, Index first);

  std::vector<Bounds> bounds_;
  std::vector<double> cost_;
  std::vector<Row> rows_;
  std::vector<Index> part_of_;  ///< per variable
  std::vector<Part> parts_;     ///< empty where a search would have to begin anew
};

}  // namespace croquis
