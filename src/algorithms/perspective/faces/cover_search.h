// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/perspective/faces/solid_graph.h"
#include "croquis/base/progress.h"

namespace croquis {

/// Which candidates to choose from, for edges that are covered together.
struct CoverProblem {
  const SolidGraph& graph;
  const std::vector<FaceCandidate>& candidates;
  std::vector<Index> edges;    ///< of the graph, ascending; all edges of the members and none else
  std::vector<Index> members;  ///< candidates, ascending
  std::vector<Index> fixed;    ///< members that must be chosen
  bool partial = false;        ///< sides may stay open, at a cost
  double margin = 0;
  std::size_t max_covers = 9;
  std::size_t node_limit = 200000;
};

/// What an open side of an edge costs in a partial cover; the second one costs less, so that rather a few edges are
/// without faces than more of them with one.
inline constexpr double open_side_cost = 3;
inline constexpr double second_open_side_cost = 2.5;

struct Cover {
  std::vector<Index> chosen;  ///< candidates, ascending
  double cost = 0;
  double deviation = 0;  ///< the greatest of the chosen
};

struct CoverResult {
  std::vector<Cover> covers;  ///< best first
  std::size_t nodes = 0;
  bool limited = false;  ///< the search ended before all was seen
};

/// Chooses candidates so that every edge is in exactly two, none overlap in a plane, the faces around each vertex
/// follow each other in one circle and can be oriented, at the least sum of cost - 1.
///
/// Branch and bound: the edge with the fewest choices is decided first. The bound is Lagrange's: prices of edges, found
/// by subgradient steps, make candidates that can't be in a good cover dear, so that most are out before the search.
CoverResult search_covers(const CoverProblem& problem, Progress& progress);

}  // namespace croquis
