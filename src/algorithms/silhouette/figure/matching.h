// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// A pair that may be matched, at a price.
struct MatchingEdge {
  Index a = 0;
  Index b = 0;
  double cost = 0;
};

/// Enumerates perfect matchings of a graph from the cheapest on, by best-first branch and bound.
///
/// The bound of a partial matching is its cost plus the dual bound of the assignment problem on the rest: with
/// prices p such that p(a)+p(b) <= cost(a,b), no matching is cheaper than the sum of prices, and every edge taken adds
/// what it costs above them. Prices come from the Hungarian method on the doubled graph, O(n³).
class MatchingSearch {
 public:
  /// @param maximum_states bound of the search: partial matchings that are looked at
  MatchingSearch(Index nodes, std::vector<MatchingEdge> edges, std::size_t maximum_states);

  /// The next matching as edge indices, ascending; none when there are no more or the bound was reached.
  std::optional<std::vector<Index>> next();

  double last_cost() const { return last_cost_; }
  bool limit_reached() const { return limit_reached_; }

 private:
  struct State {
    double cost = 0;  ///< above the sum of all prices
    std::uint32_t parent = 0;
    Index edge = no_index;  ///< that its parent lacks
    Index depth = 0;
  };

  struct Later;

  std::vector<double> prices() const;
  std::vector<Index> path(std::uint32_t state) const;
  void expand(std::uint32_t state, const std::vector<Index>& taken);

  Index nodes_;
  std::vector<MatchingEdge> edges_;
  std::vector<std::vector<Index>> edges_of_;  ///< per node, ascending by reduced cost
  std::vector<double> reduced_;               ///< per edge
  std::size_t maximum_states_;
  std::vector<State> states_;
  std::vector<std::uint32_t> heap_;
  double price_sum_ = 0;
  double last_cost_ = 0;
  bool limit_reached_ = false;
};

}  // namespace croquis::silhouette
