// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/edge_matching.h"

#include <algorithm>
#include <string>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::subdivision {
namespace {

[[noreturn]] void fail(const char* what, Index a, Index b) {
  throw Error(make_error(Category::Internal, "E_INTERNAL",
                         std::string(what) + " between the new vertices " + std::to_string(a) + " and " +
                             std::to_string(b) + ": a mistake of the refinement, please report the cage."));
}

}  // namespace

void EdgeMatching::add(Index half_edge, Index from, Index to) {
  const auto [low, high] = std::minmax(from, to);
  open_.push_back({std::uint64_t{low} << 32 | high, half_edge, from < to});
}

void EdgeMatching::match(Index quads_begin, Index quads_end) {
  std::sort(open_.begin(), open_.end(), [](const Open& a, const Open& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.half_edge < b.half_edge;
  });
  edges_.reserve((open_.size() + 1) / 2);
  const auto is_quads = [&](Index half_edge) { return half_edge >= quads_begin && half_edge < quads_end; };
  for (std::size_t i = 0; i < open_.size();) {
    const std::uint64_t ends = open_[i].ends;
    Edge edge{static_cast<Index>(ends >> 32), static_cast<Index>(ends), open_[i].half_edge, no_index, no_index};
    const auto same = [&](std::size_t j) { return j < open_.size() && open_[j].ends == ends; };
    if (same(i + 1)) {
      if (open_[i].ascending == open_[i + 1].ascending || same(i + 2)) fail("Faces don't fit", edge.low, edge.high);
      edge.upper = open_[i + 1].half_edge;
    }
    if (is_quads(edge.lower)) {
      edge.number = edge.lower - quads_begin;
    } else if (edge.upper != no_index && is_quads(edge.upper)) {
      edge.number = edge.upper - quads_begin;
    } else {
      edge.number = quads_end - quads_begin + static_cast<Index>(new_edges_++);
    }
    i += edge.upper == no_index ? 1 : 2;
    edges_.push_back(edge);
  }
}

Index EdgeMatching::edge_between(Index a, Index b) const {
  const auto key = std::minmax(a, b);
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), key, [](const Edge& edge, const auto& wanted) {
    return std::pair(edge.low, edge.high) < std::pair(wanted.first, wanted.second);
  });
  if (found == edges_.end() || found->low != key.first || found->high != key.second) fail("No edge", a, b);
  return found->number;
}

}  // namespace croquis::subdivision
