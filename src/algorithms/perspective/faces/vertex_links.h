// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "algorithms/perspective/faces/face_candidate.h"
#include "algorithms/perspective/faces/solid_graph.h"

namespace croquis {

/// Which edges follow each other around each vertex by the faces chosen so far. Faces can be taken back, last first.
class VertexLinks {
 public:
  /// @param edges of the graph, that take part
  VertexLinks(const SolidGraph& graph, const std::vector<Index>& edges)
      : graph_(graph), degree_(graph.points.size(), 0), parent_(2 * graph.edges.size()), size_(parent_.size()) {
    for (const Index e : edges) {
      ++degree_[graph.edges[e].start];
      ++degree_[graph.edges[e].end];
    }
    clear();
  }

  void clear() {
    std::iota(parent_.begin(), parent_.end(), Index{0});
    std::ranges::fill(size_, 1);
    joined_.clear();
    marks_.clear();
  }

  /// @param strict whether a circle around a vertex must have all edges that meet there
  /// @return whether the face fits the others; it is added in any case
  bool add(const FaceCandidate& face, bool strict) {
    marks_.push_back(joined_.size());
    bool fits = true;
    for (const std::vector<Index>& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index from = SolidGraph::twin(loop[i]), to = loop[(i + 1) % loop.size()];
        fits = join(from, to) || !strict ? fits : false;
      }
    }
    return fits;
  }

  void take_back() {
    while (joined_.size() > marks_.back()) {
      const Index child = joined_.back();
      joined_.pop_back();
      size_[parent_[child]] -= size_[child];
      parent_[child] = child;
    }
    marks_.pop_back();
  }

 private:
  Index root(Index half) const {
    while (parent_[half] != half) half = parent_[half];
    return half;
  }

  /// False if that closes a circle without all edges of the vertex.
  bool join(Index a, Index b) {
    Index low = root(a), high = root(b);
    if (low == high) return size_[low] == degree_[graph_.origin(a)];
    if (size_[low] > size_[high]) std::swap(low, high);
    parent_[low] = high;
    size_[high] += size_[low];
    joined_.push_back(low);
    return true;
  }

  const SolidGraph& graph_;
  std::vector<Index> degree_, parent_, size_;
  std::vector<Index> joined_;
  std::vector<std::size_t> marks_;
};

}  // namespace croquis
