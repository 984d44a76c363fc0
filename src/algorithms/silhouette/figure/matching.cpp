// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/matching.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace croquis::silhouette {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Beyond this many nodes the cubic method costs more than it saves; half the cheapest edge is a price as well.
constexpr Index most_nodes_for_assignment = 500;

/// One augmenting path of the Hungarian method, from a free row: shortest reduced cost to a free column.
void augment(const std::vector<std::vector<double>>& cost, Index row, std::vector<double>& u, std::vector<double>& v,
             std::vector<Index>& row_of) {
  const auto n = static_cast<Index>(cost.size());
  std::vector<double> least(n + 1, infinity);
  std::vector<Index> way(n + 1, 0);
  std::vector<char> used(n + 1, 0);
  row_of[0] = row + 1;
  Index column = 0;
  do {
    used[column] = 1;
    const Index from = row_of[column];
    double delta = infinity;
    Index next = 0;
    for (Index j = 1; j <= n; ++j) {
      if (used[j]) continue;
      const double reduced = cost[from - 1][j - 1] - u[from] - v[j];
      if (reduced < least[j]) {
        least[j] = reduced;
        way[j] = column;
      }
      if (least[j] < delta) {
        delta = least[j];
        next = j;
      }
    }
    for (Index j = 0; j <= n; ++j) {
      if (used[j]) {
        u[row_of[j]] += delta;
        v[j] -= delta;
      } else {
        least[j] -= delta;
      }
    }
    column = next;
  } while (row_of[column] != 0);
  for (; column != 0; column = way[column]) row_of[column] = row_of[way[column]];
}

}  // namespace

/// Order of the heap: the cheapest state comes out first, of equal ones the deepest, then the oldest.
struct MatchingSearch::Later {
  const std::vector<State>& states;

  bool operator()(std::uint32_t a, std::uint32_t b) const {
    return std::tuple(states[a].cost, -static_cast<double>(states[a].depth), a) >
           std::tuple(states[b].cost, -static_cast<double>(states[b].depth), b);
  }
};

MatchingSearch::MatchingSearch(Index nodes, std::vector<MatchingEdge> edges, std::size_t maximum_states)
    : nodes_(nodes), edges_(std::move(edges)), edges_of_(nodes), maximum_states_(maximum_states) {
  for (Index e = 0; e < edges_.size(); ++e) {
    edges_of_[edges_[e].a].push_back(e);
    edges_of_[edges_[e].b].push_back(e);
  }
  const std::vector<double> price = prices();
  for (const double p : price) price_sum_ += p;
  for (const MatchingEdge& edge : edges_) {
    reduced_.push_back(std::max(0.0, edge.cost - price[edge.a] - price[edge.b]));
  }
  for (std::vector<Index>& list : edges_of_) {
    std::sort(list.begin(), list.end(),
              [this](Index a, Index b) { return std::tuple(reduced_[a], a) < std::tuple(reduced_[b], b); });
  }
  if (nodes_ % 2 != 0) return;
  states_.push_back({});
  heap_.push_back(0);
}

std::vector<double> MatchingSearch::prices() const {
  std::vector<double> price(nodes_, 0.0);
  double dearest = 0;
  for (const MatchingEdge& edge : edges_) dearest = std::max(dearest, edge.cost);
  if (nodes_ > most_nodes_for_assignment) {
    for (Index i = 0; i < nodes_; ++i) {
      double least = edges_of_[i].empty() ? 0 : infinity;
      for (const Index e : edges_of_[i]) least = std::min(least, edges_[e].cost);
      price[i] = least / 2;
    }
    return price;
  }
  // Pairs without an edge cost more than any matching could.
  const double forbidden = (dearest + 1) * (nodes_ + 1);
  std::vector<std::vector<double>> cost(nodes_, std::vector<double>(nodes_, forbidden));
  for (const MatchingEdge& edge : edges_) cost[edge.a][edge.b] = cost[edge.b][edge.a] = edge.cost;
  std::vector<double> u(nodes_ + 1, 0.0);
  std::vector<double> v(nodes_ + 1, 0.0);
  std::vector<Index> row_of(nodes_ + 1, 0);
  for (Index row = 0; row < nodes_; ++row) augment(cost, row, u, v, row_of);
  for (Index i = 0; i < nodes_; ++i) price[i] = (u[i + 1] + v[i + 1]) / 2;
  return price;
}

std::vector<Index> MatchingSearch::path(std::uint32_t state) const {
  std::vector<Index> taken;
  for (; states_[state].edge != no_index; state = states_[state].parent) taken.push_back(states_[state].edge);
  return taken;
}

std::optional<std::vector<Index>> MatchingSearch::next() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), Later{states_});
    const std::uint32_t state = heap_.back();
    heap_.pop_back();
    std::vector<Index> taken = path(state);
    if (states_[state].depth * 2 == nodes_) {
      last_cost_ = states_[state].cost + price_sum_;
      std::sort(taken.begin(), taken.end());
      return taken;
    }
    if (states_.size() >= maximum_states_) {
      limit_reached_ = true;
      return std::nullopt;
    }
    expand(state, taken);
  }
  return std::nullopt;
}

void MatchingSearch::expand(std::uint32_t state, const std::vector<Index>& taken) {
  std::vector<char> matched(nodes_, 0);
  for (const Index e : taken) matched[edges_[e].a] = matched[edges_[e].b] = 1;
  const auto is_free = [&](Index e) { return !matched[edges_[e].a] && !matched[edges_[e].b]; };
  Index tightest = no_index;
  std::ptrdiff_t fewest = 0;
  for (Index i = 0; i < nodes_; ++i) {
    if (matched[i]) continue;
    const std::ptrdiff_t choices = std::count_if(edges_of_[i].begin(), edges_of_[i].end(), is_free);
    if (choices == 0) return;
    if (tightest == no_index || choices < fewest) {
      tightest = i;
      fewest = choices;
    }
  }
  for (const Index e : edges_of_[tightest]) {
    if (!is_free(e)) continue;
    states_.push_back({states_[state].cost + reduced_[e], state, e, states_[state].depth + 1});
    heap_.push_back(static_cast<std::uint32_t>(states_.size() - 1));
    std::push_heap(heap_.begin(), heap_.end(), Later{states_});
  }
}

}  // namespace croquis::silhouette
