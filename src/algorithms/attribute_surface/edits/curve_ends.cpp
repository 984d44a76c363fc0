// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/curve_ends.h"

#include <algorithm>
#include <map>
#include <set>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis {

CurveEnds::CurveEnds(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance) {
  const std::size_t count = 2 * curves.size();
  DisjointSets sets(count);
  std::vector<Vec3> places;
  std::map<Index, Index> first_at_node;
  for (std::size_t end = 0; end < count; ++end) {
    const AttributeSide side{curves[end / 2], end % 2 == 0};
    places.push_back(end_place(network, side));
    const Index node = end_node(network, side);
    if (node != no_index)
      sets.unite(first_at_node.emplace(node, static_cast<Index>(end)).first->second, static_cast<Index>(end));
  }
  std::vector<Index> by_x(count);
  for (Index end = 0; end < count; ++end) by_x[end] = end;
  std::ranges::sort(by_x, {}, [&](Index end) { return places[end].x(); });
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count && places[by_x[k]].x() - places[by_x[i]].x() <= tolerance; ++k) {
      if ((places[by_x[k]] - places[by_x[i]]).norm() <= tolerance) sets.unite(by_x[i], by_x[k]);
    }
  }
  for (Index end = 0; end < count; ++end) places_.push_back(sets.root(end));
}

std::optional<Index> face_with_loop(const AttributeNetwork& network, const std::vector<Index>& curves) {
  const std::set<Index> wanted(curves.begin(), curves.end());
  for (Index face = 0; face < network.faces.size(); ++face) {
    const auto& loop = network.faces[face].loop;
    const bool same = loop.size() == wanted.size() &&
                      std::ranges::all_of(loop, [&](const AttributeSide& side) { return wanted.contains(side.curve); });
    if (same) return face;
  }
  return std::nullopt;
}

}  // namespace croquis
