// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/overlap_cycles.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace croquis::silhouette {

OverlapCycles overlap_cycles(const std::vector<std::vector<Index>>& below) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(below.size());
  for (std::size_t object = 0; object < below.size(); ++object) {
    for (const Index lower : below[object]) boost::add_edge(object, lower, graph);
  }
  OverlapCycles cycles;
  cycles.cycle.resize(below.size());
  const auto cycle = boost::make_iterator_property_map(cycles.cycle.begin(), get(boost::vertex_index, graph));
  cycles.count = boost::strong_components(graph, cycle);
  return cycles;
}

}  // namespace croquis::silhouette
