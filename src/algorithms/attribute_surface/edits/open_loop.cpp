// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/open_loop.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "croquis/attribute_surface/loop_search.h"
#include "croquis/attribute_surface/network_elements.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

std::vector<Index> border_curves(const AttributeNetwork& network) {
  std::set<Index> inner;
  for (const AttributeFace& face : network.faces) {
    for (const InnerCurve& curve : face.inner) inner.insert(curve.curve);
  }
  std::vector<Index> curves;
  for (Index i = 0; i < network.curves.size(); ++i) {
    if (!inner.contains(i)) curves.push_back(i);
  }
  return curves;
}

/// The fewest curves that lead from the end of one back to its beginning, with it; empty for none. Positions in a list.
/// @param closed those that can't be walked along
std::vector<std::size_t> walk_round(std::size_t first, const std::vector<bool>& closed, const CurveEnds& ends) {
  const std::size_t count = closed.size();
  constexpr std::size_t none = ~std::size_t{0};
  const std::size_t goal = ends.of(first, false);
  if (ends.of(first, true) == goal) return {first};
  std::vector<std::size_t> curve_to(2 * count, none);
  std::deque<std::size_t> open{ends.of(first, true)};
  curve_to[open.front()] = first;
  while (!open.empty() && curve_to[goal] == none) {
    const std::size_t at = open.front();
    open.pop_front();
    for (std::size_t i = 0; i < count; ++i) {
      const bool starts = ends.of(i, false) == at;
      if (i == first || closed[i] || (!starts && ends.of(i, true) != at)) continue;
      const std::size_t next = ends.of(i, starts);
      if (curve_to[next] != none) continue;
      curve_to[next] = i;
      open.push_back(next);
    }
  }
  std::vector<std::size_t> walk;
  for (std::size_t at = goal; curve_to[at] != none && (walk.empty() || walk.back() != first);) {
    const std::size_t curve = curve_to[at];
    walk.push_back(curve);
    at = ends.of(curve, ends.of(curve, true) != at);
  }
  return walk;
}

}  // namespace

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

SortedLoop open_loop(const AttributeNetwork& network, const LoopSearchOptions& options) {
  const std::vector<Index> curves = border_curves(network);
  const CurveEnds ends(network, curves, options.tolerance);
  const auto loop_of = [&](const std::vector<std::size_t>& walk) {
    std::vector<Index> loop;
    for (const std::size_t position : walk) loop.push_back(curves[position]);
    return loop;
  };
  const std::vector<bool> none(curves.size(), false);
  for (std::size_t k = curves.size(); k-- > 0;) {
    if (faces_along(network, curves[k]).size() > 1) continue;
    const std::vector<std::size_t> walk = walk_round(k, none, ends);
    std::vector<Index> loop = loop_of(walk);
    // Where that is a face, another loop of as few curves may lack its own: it doesn't go along all of these curves.
    for (std::size_t i = 0; i < walk.size() && face_with_loop(network, loop); ++i) {
      std::vector<bool> closed = none;
      closed[walk[i]] = walk[i] != k;
      const std::vector<std::size_t> other = walk_round(k, closed, ends);
      if (!other.empty() && other.size() <= walk.size()) loop = loop_of(other);
    }
    if (loop.empty() || loop.size() > options.most_sides || face_with_loop(network, loop)) continue;
    if (SortedLoop sorted = sort_loop(network, loop, options.tolerance); sorted.closed()) return sorted;
  }
  return {};
}

}  // namespace croquis
