// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/matching.h"

#include <utility>

namespace croquis::silhouette {

MatchingSearch::MatchingSearch(Index nodes, const std::vector<MatchingEdge>& edges, int maximum_branches)
    : branches_left_(maximum_branches) {
  std::vector<std::vector<IntegerProgram::Term>> one(nodes);
  for (const MatchingEdge& edge : edges) {
    const Index taken = program_.add_variable(0, 1, edge.cost);
    one[edge.a].push_back({taken, 1});
    if (edge.b != edge.a) one[edge.b].push_back({taken, 1});
  }
  for (std::vector<IntegerProgram::Term>& row : one) program_.add_row(std::move(row), 1, 1);
}

std::optional<std::vector<Index>> MatchingSearch::next() {
  if (done_ || limit_reached()) return std::nullopt;
  const IntegerProgram::Solution solution = program_.solve(branches_left_);
  branches_left_ = solution.status == IntegerProgram::Status::Limit ? 0 : branches_left_ - solution.nodes;
  done_ = solution.status != IntegerProgram::Status::Optimal;
  if (done_) return std::nullopt;
  std::vector<Index> taken;
  std::vector<IntegerProgram::Term> same;
  for (Index e = 0; e < solution.values.size(); ++e) {
    if (solution.values[e] == 0) continue;
    taken.push_back(e);
    same.push_back({e, 1});
  }
  done_ = taken.empty();
  if (!done_) program_.add_row(std::move(same), 0, static_cast<double>(taken.size()) - 1);
  return taken;
}

}  // namespace croquis::silhouette
