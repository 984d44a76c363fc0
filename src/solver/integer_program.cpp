// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/solver/integer_program.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <functional>
#include <new>
#include <thread>
#include <utility>

#include <glpk.h>

#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

// Far above what the relaxations of a drawing need (some hundred); a guard against cycling.
constexpr int maximum_simplex_iterations = 200'000;

/// Everything GLPK reads and writes, in plain arrays (index 0 unused): no destructor may be skipped by the long jump.
struct PlainProblem {
  int rows = 0;
  int columns = 0;
  int terms = 0;
  const int* term_row = nullptr;
  const int* term_column = nullptr;
  const double* term_factor = nullptr;
  const double* row_lower = nullptr;
  const double* row_upper = nullptr;
  const double* column_lower = nullptr;
  const double* column_upper = nullptr;
  const double* cost = nullptr;
  int maximum_nodes = 0;
  double gap = 0;
  int first = 0;             ///< columns up to this one are branched on first
  double* values = nullptr;  ///< result
  int outcome = -1;          ///< 0 optimal, 1 infeasible, 2 limit, 3 GLPK failed
  bool has_values = false;
  bool out_of_memory = false;  ///< why it failed
  int nodes = 0;               ///< looked at
};

int bound_type(double lower, double upper) {
  if (lower == upper) return GLP_FX;
  const bool below = std::isfinite(lower);
  const bool above = std::isfinite(upper);
  if (below && above) return GLP_DB;
  if (below) return GLP_LO;
  return above ? GLP_UP : GLP_FR;
}

struct Branching {
  int first = 0;  ///< see PlainProblem
  int nodes = 0;
  int maximum = 0;
  bool reached = false;
};

/// Counts nodes, and branches upon the most fractional of the first variables while any of those is fractional.
void guide(glp_tree* tree, void* info) {
  auto* branching = static_cast<Branching*>(info);
  if (glp_ios_reason(tree) == GLP_IBRANCH) {
    int column = 0;
    double most = 0;
    for (int j = 1; j <= branching->first; ++j) {
      if (glp_ios_can_branch(tree, j) == 0) continue;
      const double value = glp_get_col_prim(glp_ios_get_prob(tree), j);
      const double fraction = std::abs(value - std::round(value));
      if (column != 0 && fraction <= most) continue;
      most = fraction;
      column = j;
    }
    if (column != 0) glp_ios_branch_upon(tree, column, GLP_NO_BRNCH);
    return;
  }
  if (glp_ios_reason(tree) != GLP_ISELECT || ++branching->nodes <= branching->maximum) return;
  branching->reached = true;
  glp_ios_terminate(tree);
}

void load(glp_prob* problem, const PlainProblem& plain) {
  glp_set_obj_dir(problem, GLP_MIN);
  if (plain.rows > 0) glp_add_rows(problem, plain.rows);
  glp_add_cols(problem, plain.columns);
  for (int i = 1; i <= plain.rows; ++i) {
    glp_set_row_bnds(problem, i, bound_type(plain.row_lower[i], plain.row_upper[i]), plain.row_lower[i],
                     plain.row_upper[i]);
  }
  for (int j = 1; j <= plain.columns; ++j) {
    glp_set_col_kind(problem, j, GLP_IV);
    glp_set_col_bnds(problem, j, bound_type(plain.column_lower[j], plain.column_upper[j]), plain.column_lower[j],
                     plain.column_upper[j]);
    glp_set_obj_coef(problem, j, plain.cost[j]);
  }
  glp_load_matrix(problem, plain.terms, plain.term_row, plain.term_column, plain.term_factor);
}

int run(glp_prob* problem, PlainProblem& plain, Branching& guided) {
  glp_smcp simplex;
  glp_init_smcp(&simplex);
  simplex.msg_lev = GLP_MSG_OFF;
  simplex.it_lim = maximum_simplex_iterations;
  simplex.meth = GLP_DUALP;
  if (glp_simplex(problem, &simplex) != 0) return glp_get_status(problem) == GLP_NOFEAS ? 1 : 2;
  if (glp_get_status(problem) != GLP_OPT) return 1;
  glp_iocp branching;
  glp_init_iocp(&branching);
  branching.msg_lev = GLP_MSG_OFF;
  // Far fewer branches than by the default on the programs of drawings, whose relaxations are mostly whole numbers.
  branching.br_tech = GLP_BR_MFV;
  if (plain.gap > 0) branching.mip_gap = plain.gap;
  guided.first = plain.first;
  guided.maximum = plain.maximum_nodes;
  branching.cb_func = guide;
  branching.cb_info = &guided;
  const int code = glp_intopt(problem, &branching);
  plain.nodes = guided.nodes;
  const bool stopped = guided.reached || code == GLP_ESTOP;
  if (code != 0 && code != GLP_EMIPGAP && !stopped) return 3;
  const int status = glp_mip_status(problem);
  if (status != GLP_OPT && status != GLP_FEAS) return stopped ? 2 : 1;
  for (int j = 1; j <= plain.columns; ++j) plain.values[j] = glp_mip_col_val(problem, j);
  plain.has_values = true;
  return stopped ? 2 : 0;
}

/// GLPK's error hook must not return and may not throw through C: it jumps to where GLPK was called from. This frame
/// and all below it hold plain data only. What GLPK had allocated goes with its environment.
void solve_plain(PlainProblem& plain) {
  glp_term_out(GLP_OFF);
  // GLPK turns its output on again to report an error; a hook that claims to have shown it keeps it quiet. Only the
  // text gives the reason: "no memory available", "memory allocation limit exceeded".
  const auto listen = [](void* info, const char* words) {
    auto& heard = *static_cast<PlainProblem*>(info);
    heard.out_of_memory = heard.out_of_memory || std::strstr(words, "memory") != nullptr;
    return 1;
  };
  glp_term_hook(listen, &plain);
  std::jmp_buf stop;
  Branching guided;
  if (setjmp(stop) != 0) {
    plain.outcome = 3;
  } else {
    glp_error_hook([](void* info) { std::longjmp(*static_cast<std::jmp_buf*>(info), 1); }, &stop);
    glp_prob* problem = glp_create_prob();
    load(problem, plain);
    plain.outcome = run(problem, plain, guided);
    glp_delete_prob(problem);
  }
  glp_error_hook(nullptr, nullptr);
  glp_free_env();
}

[[noreturn]] void throw_refused() {
  throw Error(make_error(Category::Internal, "E_INTERNAL", "The integer program of the drawing was refused by GLPK"));
}

}  // namespace

Index IntegerProgram::add_variable(double lower, double upper, double cost) {
  variables_.push_back({lower, upper, cost});
  return static_cast<Index>(variables_.size() - 1);
}

void IntegerProgram::add_row(std::vector<Term> terms, double lower, double upper) {
  // GLPK refuses a variable that stands twice in a row.
  std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.variable < b.variable; });
  std::vector<Term> merged;
  for (const Term& term : terms) {
    if (!merged.empty() && merged.back().variable == term.variable) {
      merged.back().factor += term.factor;
    } else {
      merged.push_back(term);
    }
  }
  rows_.push_back({std::move(merged), lower, upper});
}

void IntegerProgram::set_bounds(Index variable, double lower, double upper) {
  variables_[variable].lower = lower;
  variables_[variable].upper = upper;
}

/// Variables that rows connect, and those rows.
struct IntegerProgram::Part {
  std::vector<Index> variables;  ///< ascending
  IntegerProgram program;
};

std::vector<IntegerProgram::Part> IntegerProgram::parts() const {
  DisjointSets connected(variables_.size());
  for (const Row& row : rows_) {
    for (const Term& term : row.terms) connected.unite(row.terms.front().variable, term.variable);
  }
  std::vector<Index> part, number;
  std::vector<Part> parts(connected.number(part));
  for (Index v = 0; v < variables_.size(); ++v) {
    Part& own = parts[part[v]];
    number.push_back(static_cast<Index>(own.variables.size()));
    own.variables.push_back(v);
    own.program.variables_.push_back(variables_[v]);
  }
  for (const Row& row : rows_) {
    if (row.terms.empty()) continue;
    std::vector<Row>& rows = parts[part[row.terms.front().variable]].program.rows_;
    rows.push_back(row);
    for (Term& term : rows.back().terms) term.variable = number[term.variable];
  }
  return parts;
}

/// The best value of a variable that is in no row; none where it has no bound, or bounds that contradict.
std::optional<int> IntegerProgram::free_value() const {
  const Variable& only = variables_.front();
  double best = std::max(only.lower, std::min(only.upper, 0.0));
  if (only.cost != 0) best = only.cost > 0 ? only.lower : only.upper;
  if (!std::isfinite(best) || !(only.lower <= only.upper)) return std::nullopt;
  return static_cast<int>(std::lround(best));
}

IntegerProgram::Solution IntegerProgram::solve(int maximum_nodes, double gap, Index first) const {
  Solution solution;
  for (const Row& row : rows_) {
    if (row.terms.empty() && (row.lower > 0 || row.upper < 0)) return solution;
    if (!row.terms.empty() && row.terms.back().variable >= variables_.size()) throw_refused();
  }
  std::vector<int> values(variables_.size(), 0);
  bool limited = false;
  for (const Part& part : parts()) {
    const int nodes = std::max(1, maximum_nodes - solution.nodes);
    const std::optional<int> free = part.program.rows_.empty() ? part.program.free_value() : std::nullopt;
    const auto own_first = static_cast<Index>(std::ranges::lower_bound(part.variables, first) - part.variables.begin());
    const Solution own =
        free ? Solution{Status::Optimal, {*free}, 0} : part.program.solve_connected(nodes, gap, own_first);
    solution.nodes += own.nodes;
    solution.status = own.status;
    limited = limited || own.status == Status::Limit;
    if (own.values.empty()) return solution;
    for (std::size_t i = 0; i < own.values.size(); ++i) values[part.variables[i]] = own.values[i];
  }
  solution.status = limited ? Status::Limit : Status::Optimal;
  solution.values = std::move(values);
  return solution;
}

IntegerProgram::Solution IntegerProgram::solve_connected(int maximum_nodes, double gap, Index first) const {
  Solution solution;
  std::vector<int> term_row{0};
  std::vector<int> term_column{0};
  std::vector<double> term_factor{0};
  std::vector<double> row_lower{0};
  std::vector<double> row_upper{0};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    row_lower.push_back(rows_[i].lower);
    row_upper.push_back(rows_[i].upper);
    for (const Term& term : rows_[i].terms) {
      term_row.push_back(static_cast<int>(i + 1));
      term_column.push_back(static_cast<int>(term.variable + 1));
      term_factor.push_back(term.factor);
    }
  }
  std::vector<double> column_lower{0};
  std::vector<double> column_upper{0};
  std::vector<double> cost{0};
  for (const Variable& variable : variables_) {
    column_lower.push_back(variable.lower);
    column_upper.push_back(variable.upper);
    cost.push_back(variable.cost);
  }
  std::vector<double> values(variables_.size() + 1, 0.0);
  PlainProblem plain{static_cast<int>(rows_.size()),
                     static_cast<int>(variables_.size()),
                     static_cast<int>(term_row.size() - 1),
                     term_row.data(),
                     term_column.data(),
                     term_factor.data(),
                     row_lower.data(),
                     row_upper.data(),
                     column_lower.data(),
                     column_upper.data(),
                     cost.data(),
                     maximum_nodes,
                     gap,
                     static_cast<int>(first),
                     values.data(),
                     -1,
                     false,
                     false,
                     0};
  std::thread(solve_plain, std::ref(plain)).join();
  if (plain.outcome == 3 && plain.out_of_memory) throw std::bad_alloc();
  if (plain.outcome == 3) throw_refused();
  solution.status = plain.outcome == 0 ? Status::Optimal : plain.outcome == 1 ? Status::Infeasible : Status::Limit;
  solution.nodes = plain.nodes;
  if (!plain.has_values) return solution;
  for (std::size_t j = 1; j < values.size(); ++j) solution.values.push_back(static_cast<int>(std::lround(values[j])));
  return solution;
}

}  // namespace croquis
