// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/views/turned_views.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::remeshing {
namespace {

using Neighbours = std::map<Index, std::vector<std::pair<Index, bool>>>;  // and whether they are opposed

/// A tree of the strongest pairs for each group.
Neighbours strongest(std::vector<ViewPair> pairs, std::size_t components) {
  std::ranges::stable_sort(pairs, std::greater(), &ViewPair::count);
  DisjointSets sets(components);
  Neighbours neighbours;
  for (const ViewPair& pair : pairs) {
    if (sets.root(pair.first) == sets.root(pair.second)) continue;
    sets.unite(pair.first, pair.second);
    neighbours[pair.first].emplace_back(pair.second, pair.opposed);
    neighbours[pair.second].emplace_back(pair.first, pair.opposed);
  }
  return neighbours;
}

}  // namespace

std::vector<Index> minority_of(std::vector<ViewPair> pairs, const std::vector<double>& areas) {
  const Neighbours neighbours = strongest(std::move(pairs), areas.size());
  std::map<Index, int> side;
  std::vector<Index> turned;
  for (const auto& [seed, others] : neighbours) {
    if (side.contains(seed)) continue;
    std::array<std::vector<Index>, 2> sides;
    std::array<double, 2> area = {0, 0};
    std::vector<Index> pending = {seed};
    side[seed] = 0;
    while (!pending.empty()) {
      const Index here = pending.back();
      pending.pop_back();
      const auto own = static_cast<std::size_t>(side[here]);
      sides[own].push_back(here);
      area[own] += areas[here];
      for (const auto& [other, opposed] : neighbours.at(here))
        if (side.try_emplace(other, opposed ? 1 - side[here] : side[here]).second) pending.push_back(other);
    }
    const std::vector<Index>& fewer = sides[area[1] > area[0] ? 0 : 1];
    turned.insert(turned.end(), fewer.begin(), fewer.end());
  }
  std::ranges::sort(turned);
  return turned;
}

}  // namespace croquis::remeshing
