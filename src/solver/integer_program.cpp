// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/solver/integer_program.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <exception>
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
// Nearer to a whole number than this a relaxation's value is one.
constexpr double whole_tolerance = 1e-5;
constexpr double cost_tolerance = 1e-9;

[[noreturn]] void throw_refused() {
  throw Error(make_error(Category::Internal, "E_INTERNAL", "The integer program of the drawing was refused by GLPK"));
}

int bound_type(double lower, double upper) {
  if (lower == upper) return GLP_FX;
  const bool below = std::isfinite(lower);
  const bool above = std::isfinite(upper);
  if (below && above) return GLP_DB;
  if (below) return GLP_LO;
  return above ? GLP_UP : GLP_FR;
}

/// Calls GLPK. Its error hook must not return and may not throw through C: it jumps back here, over frames that hold
/// plain data only. What GLPK had allocated goes with its environment.
/// @param out_of_memory why GLPK failed, as its terminal hook heard it
template <typename Call>
void guarded(const bool& out_of_memory, const Call& call) {
  std::jmp_buf stop;
  if (setjmp(stop) != 0) {
    if (out_of_memory) throw std::bad_alloc();
    throw_refused();
  }
  glp_error_hook([](void* to) { std::longjmp(*static_cast<std::jmp_buf*>(to), 1); }, &stop);
  call();
  glp_error_hook(nullptr, nullptr);
}

/// GLPK's environment belongs to the thread: it can be thrown away, after an error too, without losing other problems.
/// @param work is given whether GLPK was heard to be out of memory
template <typename Work>
void in_own_environment(const Work& work) {
  std::exception_ptr failure;
  std::thread([&] {
    bool out_of_memory = false;
    // GLPK turns its output on again to report an error; a hook that claims to have shown it keeps it quiet. Only the
    // text gives the reason: "no memory available", "memory allocation limit exceeded".
    const auto listen = [](void* heard, const char* words) {
      bool& memory = *static_cast<bool*>(heard);
      memory = memory || std::strstr(words, "memory") != nullptr;
      return 1;
    };
    glp_term_out(GLP_OFF);
    glp_term_hook(listen, &out_of_memory);
    try {
      work(out_of_memory);
    } catch (...) {
      failure = std::current_exception();
    }
    glp_error_hook(nullptr, nullptr);
    glp_free_env();
  }).join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

/// A part's relaxation in GLPK. All numbers of GLPK begin with 1.
class IntegerProgram::Relaxation {
 public:
  /// @param out_of_memory see `guarded`; both must outlive it
  Relaxation(const Part& part, const bool& out_of_memory) : part_(part), out_of_memory_(out_of_memory) {
    guarded(out_of_memory_, [this] { load(); });
  }

  /// The least cost within a node's bounds; none where there is no solution.
  std::optional<double> solve(const Node& node) {
    std::optional<double> cost;
    guarded(out_of_memory_, [&] {
      start_from(node);
      glp_smcp simplex;
      glp_init_smcp(&simplex);
      simplex.msg_lev = GLP_MSG_OFF;
      simplex.it_lim = maximum_simplex_iterations;
      simplex.meth = GLP_DUALP;
      int code = glp_simplex(problem_, &simplex);
      if (code == GLP_EBADB || code == GLP_ESING || code == GLP_ECOND) {  // rows came, and it is no basis any more
        glp_std_basis(problem_);
        code = glp_simplex(problem_, &simplex);
      }
      if (code == 0 && glp_get_status(problem_) == GLP_OPT) cost = glp_get_obj_val(problem_);
      gave_up_ = gave_up_ || (code != 0 && glp_get_status(problem_) != GLP_NOFEAS);
    });
    return cost;
  }

  /// Whether the simplex method ended before it knew.
  bool gave_up() const { return gave_up_; }

  double value(Index variable) const { return glp_get_col_prim(problem_, number(variable)); }

  std::vector<int> basis() const {
    std::vector<int> statuses;
    for (int i = 1; i <= glp_get_num_rows(problem_); ++i) statuses.push_back(glp_get_row_stat(problem_, i));
    for (int j = 1; j <= glp_get_num_cols(problem_); ++j) statuses.push_back(glp_get_col_stat(problem_, j));
    return statuses;
  }

 private:
  static int number(Index index) { return static_cast<int>(index) + 1; }

  void load() {
    problem_ = glp_create_prob();
    glp_set_obj_dir(problem_, GLP_MIN);
    if (!part_.rows.empty()) glp_add_rows(problem_, number(static_cast<Index>(part_.rows.size())) - 1);
    glp_add_cols(problem_, number(static_cast<Index>(part_.cost.size())) - 1);
    for (Index v = 0; v < part_.cost.size(); ++v) glp_set_obj_coef(problem_, number(v), part_.cost[v]);
    for (Index r = 0; r < part_.rows.size(); ++r) {
      const auto& [terms, lower, upper] = part_.rows[r];
      glp_set_row_bnds(problem_, number(r), bound_type(lower, upper), lower, upper);
      columns_.assign(1, 0);
      factors_.assign(1, 0);
      for (const Term& term : terms) {
        columns_.push_back(number(term.variable));
        factors_.push_back(term.factor);
      }
      glp_set_mat_row(problem_, number(r), static_cast<int>(terms.size()), columns_.data(), factors_.data());
    }
  }

  void start_from(const Node& node) {
    for (Index v = 0; v < node.bounds.size(); ++v) {
      const auto [lower, upper] = node.bounds[v];
      glp_set_col_bnds(problem_, number(v), bound_type(lower, upper), lower, upper);
    }
    if (node.basis.empty()) return glp_std_basis(problem_);
    const std::size_t rows = node.basis.size() - node.bounds.size();
    for (Index r = 0; r < part_.rows.size(); ++r) {
      glp_set_row_stat(problem_, number(r), r < rows ? node.basis[r] : GLP_BS);
    }
    for (Index v = 0; v < node.bounds.size(); ++v) glp_set_col_stat(problem_, number(v), node.basis[rows + v]);
  }

  const Part& part_;
  const bool& out_of_memory_;
  glp_prob* problem_ = nullptr;  ///< goes with the environment
  std::vector<int> columns_;     ///< outlives jumps
  std::vector<double> factors_;
  bool gave_up_ = false;
};

Index IntegerProgram::add_variable(double lower, double upper, double cost) {
  parts_.clear();
  bounds_.push_back({lower, upper});
  cost_.push_back(cost);
  return static_cast<Index>(cost_.size() - 1);
}

void IntegerProgram::set_bounds(Index variable, double lower, double upper) {
  parts_.clear();
  bounds_[variable] = {lower, upper};
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
  if (!parts_.empty()) add_to_part(rows_.back());
}

void IntegerProgram::find_parts() {
  DisjointSets connected(cost_.size());
  for (const Row& row : rows_) {
    for (const Term& term : row.terms) connected.unite(row.terms.front().variable, term.variable);
  }
  parts_.resize(connected.number(part_of_));
  for (Part& part : parts_) part.open.resize(1);
  for (Index v = 0; v < cost_.size(); ++v) {
    Part& part = parts_[part_of_[v]];
    part.variables.push_back(v);
    part.cost.push_back(cost_[v]);
    part.open.front().bounds.push_back(bounds_[v]);
  }
  for (const Row& row : rows_) add_to_part(row);
}

/// The part goes on with its search; where the row connects parts, all begin anew.
void IntegerProgram::add_to_part(const Row& row) {
  if (row.terms.empty()) return;
  const Index of = part_of_[row.terms.front().variable];
  Row own = row;
  for (Term& term : own.terms) {
    if (term.variable >= part_of_.size() || part_of_[term.variable] != of) return parts_.clear();
    const auto position = std::ranges::lower_bound(parts_[of].variables, term.variable);
    term.variable = static_cast<Index>(position - parts_[of].variables.begin());
  }
  parts_[of].rows.push_back(std::move(own));
}

/// The best value of a variable that is in no row; none where it has no bound, or bounds that contradict.
std::optional<int> IntegerProgram::free_value(const Part& part) {
  const auto [lower, upper] = part.open.front().bounds.front();
  double best = std::max(lower, std::min(upper, 0.0));
  if (part.cost.front() != 0) best = part.cost.front() > 0 ? lower : upper;
  if (!std::isfinite(best) || !(lower <= upper)) return std::nullopt;
  return static_cast<int>(std::lround(best));
}

/// Of the open nodes that may hold a solution as good as any the deepest one.
std::size_t IntegerProgram::most_promising(const Part& part, double gap) {
  const double least = std::ranges::min_element(part.open, {}, &Node::cost)->cost;
  const double enough = std::isfinite(least) ? least + gap * std::abs(least) + cost_tolerance : least;
  std::size_t found = part.open.size() - 1;
  while (part.open[found].cost > enough) --found;
  return found;
}

/// Solves a node's relaxation: it is dropped, gets values, or becomes two.
void IntegerProgram::branch(Part& part, Node node, Relaxation& relaxation, Index first) {
  const std::optional<double> cost = relaxation.solve(node);
  if (!cost) return;
  node.cost = std::max(node.cost, *cost);
  node.basis = relaxation.basis();
  node.rows = part.rows.size();
  Index most_broken = no_index;
  double most = whole_tolerance;
  node.values.clear();
  for (Index v = 0; v < part.cost.size() && (v != first || most_broken == no_index); ++v) {
    const double value = relaxation.value(v);
    const double off = std::abs(value - std::round(value));
    node.values.push_back(static_cast<int>(std::lround(value)));
    if (off <= most) continue;
    most = off;
    most_broken = v;
  }
  if (most_broken == no_index) return part.open.push_back(std::move(node));
  node.values.clear();
  const double value = relaxation.value(most_broken);
  Node below = node;
  below.bounds[most_broken].upper = std::floor(value);
  node.bounds[most_broken].lower = std::floor(value) + 1;
  if (value - std::floor(value) < 0.5) std::swap(below, node);
  part.open.push_back(std::move(below));
  part.open.push_back(std::move(node));
}

bool IntegerProgram::is_solution(const Part& part, const Node& node) {
  return !node.values.empty() && node.rows == part.rows.size();
}

/// What the open nodes say by themselves; none while the search has to go on.
std::optional<IntegerProgram::Solution> IntegerProgram::outcome(const Part& part, double gap, bool is_over) {
  if (part.open.empty()) return Solution{};
  const Node& promising = part.open[most_promising(part, gap)];
  if (is_solution(part, promising)) return Solution{Status::Optimal, promising.values};
  if (!is_over) return std::nullopt;
  const Node* best = best_known(part);
  return Solution{Status::Limit, best != nullptr ? best->values : std::vector<int>{}};
}

/// The best solution among the open nodes; null where there is none.
const IntegerProgram::Node* IntegerProgram::best_known(const Part& part) {
  const Node* best = nullptr;
  for (const Node& node : part.open) {
    if (is_solution(part, node) && (best == nullptr || node.cost < best->cost)) best = &node;
  }
  return best;
}

/// Goes down from the most promising node until there is a solution or none, then from the next one.
IntegerProgram::Solution IntegerProgram::solve_part(Part& part, int maximum_nodes, double gap, Index first) {
  std::optional<Solution> found = outcome(part, gap, false);
  if (found) return *found;
  int nodes = 0;
  in_own_environment([&](const bool& out_of_memory) {
    Relaxation relaxation(part, out_of_memory);
    for (bool descending = false; !found; found = outcome(part, gap, nodes >= maximum_nodes)) {
      const Node* known = best_known(part);
      const bool goes_on = descending && (known == nullptr || part.open.back().cost < known->cost);
      const std::size_t next = goes_on ? part.open.size() - 1 : most_promising(part, gap);
      Node node = std::move(part.open[next]);
      part.open.erase(part.open.begin() + static_cast<std::ptrdiff_t>(next));
      const std::size_t others = part.open.size();
      branch(part, std::move(node), relaxation, first);
      descending = part.open.size() > others + 1;
      ++nodes;
    }
    if (part.open.empty() && relaxation.gave_up()) found->status = Status::Limit;
  });
  found->nodes = nodes;
  return *found;
}

IntegerProgram::Solution IntegerProgram::solve(int maximum_nodes, double gap, Index first) {
  Solution solution;
  for (const Row& row : rows_) {
    if (row.terms.empty() && (row.lower > 0 || row.upper < 0)) return solution;
    if (!row.terms.empty() && row.terms.back().variable >= cost_.size()) throw_refused();
  }
  if (parts_.empty()) find_parts();
  std::vector<int> values(cost_.size(), 0);
  bool limited = false;
  for (Part& part : parts_) {
    const std::optional<int> free = part.rows.empty() ? free_value(part) : std::nullopt;
    const auto own_first = static_cast<Index>(std::ranges::lower_bound(part.variables, first) - part.variables.begin());
    const int nodes = std::max(1, maximum_nodes - solution.nodes);
    const Solution own = free ? Solution{Status::Optimal, {*free}, 0} : solve_part(part, nodes, gap, own_first);
    solution.nodes += own.nodes;
    solution.status = own.status;
    limited = limited || own.status == Status::Limit;
    if (own.values.empty()) return solution;
    for (std::size_t i = 0; i < own.values.size(); ++i) values[part.variables[i]] = own.values[i];
  }
  solution.status = limited ? Status::Limit : Status::Optimal;
  solution.values = std::move(values);
  for (std::size_t i = 0; i < cost_.size(); ++i) solution.cost += cost_[i] * solution.values[i];
  return solution;
}

}  // namespace croquis
