// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/boundary_walk.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace croquis {
namespace {

/// A rim edge as seen from one of its ends.
struct RimEnd {
  Index vertex = no_index;
  Index edge = no_index;  ///< number among the rim's edges
  Index fan = no_index;   ///< of the vertex
  bool leaves = false;    ///< the face runs from this vertex along the edge
};

/// Walks along the edges that have one face, each once.
class BoundaryWalk {
 public:
  explicit BoundaryWalk(const MeshTopology& topology) {
    for (Index edge = 0; edge < topology.edge_count(); ++edge) {
      const auto corners = topology.edge_corners(edge);
      if (corners.size() != 1) continue;
      const Index from = corners.front();
      const Index to = topology.next(from);
      const Index number = static_cast<Index>(ends_.size() / 2);
      ends_.push_back({topology.vertex(from), number, topology.fan(from), true});
      ends_.push_back({topology.vertex(to), number, topology.fan(to), false});
    }
    by_vertex_ = ends_;
    std::sort(by_vertex_.begin(), by_vertex_.end(), [](const RimEnd& a, const RimEnd& b) {
      return std::pair(a.vertex, a.edge) < std::pair(b.vertex, b.edge);
    });
    used_.assign(ends_.size() / 2, false);
    place_on_path_.assign(topology.vertex_count(), no_index);
  }

  std::vector<std::vector<Index>> trace() {
    // Chains that end at non-manifold edges first, from their ends: afterwards every vertex has an even number left.
    for (std::size_t i = 0; i < by_vertex_.size();) {
      const auto around = ends_at(by_vertex_[i].vertex);
      if (around.size() % 2 == 1) walk_from(around.front().vertex);
      i += around.size();
    }
    for (const RimEnd& end : by_vertex_) {
      if (!used_[end.edge]) walk_from(end.vertex);
    }
    return std::move(loops_);
  }

 private:
  std::span<const RimEnd> ends_at(Index vertex) const {
    const auto [first, last] =
        std::equal_range(by_vertex_.begin(), by_vertex_.end(), RimEnd{vertex, no_index, no_index, false},
                         [](const RimEnd& a, const RimEnd& b) { return a.vertex < b.vertex; });
    return {first, last};
  }

  /// The edge to go on with: in the same fan, else along the faces' direction, else the lowest; null at the end.
  const RimEnd* choose(Index vertex, Index fan) const {
    const RimEnd* best = nullptr;
    const auto merit = [fan](const RimEnd& end) { return (end.fan == fan ? 2 : 0) + (end.leaves ? 1 : 0); };
    for (const RimEnd& end : ends_at(vertex)) {
      if (!used_[end.edge] && (best == nullptr || merit(end) > merit(*best))) best = &end;
    }
    return best;
  }

  void walk_from(Index start) {
    Index vertex = start;
    Index fan = no_index;
    enter(vertex);
    while (const RimEnd* leaving = choose(vertex, fan)) {
      used_[leaving->edge] = true;
      const RimEnd& arriving = ends_[2 * leaving->edge + (leaving->leaves ? 1 : 0)];
      vertex = arriving.vertex;
      fan = arriving.fan;
      if (place_on_path_[vertex] != no_index)
        cut_loop(place_on_path_[vertex]);
      else
        enter(vertex);
    }
    if (path_.size() > 1) loops_.push_back(path_);
    for (const Index left : path_) place_on_path_[left] = no_index;
    path_.clear();
  }

  void enter(Index vertex) {
    place_on_path_[vertex] = static_cast<Index>(path_.size());
    path_.push_back(vertex);
  }

  /// The path has come back to the vertex at `place`, which stays on it.
  void cut_loop(Index place) {
    std::vector<Index> loop(path_.begin() + place, path_.end());
    for (std::size_t i = place + std::size_t{1}; i < path_.size(); ++i) place_on_path_[path_[i]] = no_index;
    path_.resize(place + std::size_t{1});
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    loops_.push_back(std::move(loop));
  }

  std::vector<RimEnd> ends_;  ///< two per edge: its start and its end
  std::vector<RimEnd> by_vertex_;
  std::vector<bool> used_;
  std::vector<Index> place_on_path_;
  std::vector<Index> path_;
  std::vector<std::vector<Index>> loops_;
};

}  // namespace

IndexTable trace_boundary_loops(const MeshTopology& topology) {
  std::vector<std::vector<Index>> loops = BoundaryWalk(topology).trace();
  std::sort(loops.begin(), loops.end());
  IndexTable table;
  for (const auto& loop : loops) {
    table.values.insert(table.values.end(), loop.begin(), loop.end());
    table.offsets.push_back(static_cast<Index>(table.values.size()));
  }
  return table;
}

}  // namespace croquis
