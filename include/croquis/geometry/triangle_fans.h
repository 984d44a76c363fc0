// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// The triangles around every vertex: 4 bytes per vertex and 12 per triangle. Refers to the corners it was made of.
class TriangleFans {
 public:
  /// What the edges opposite to a vertex form: around a manifold one a path or a cycle.
  enum class Link { None, Cycle, Path, Broken };

  /// @param corners three per triangle, below vertex_count; must outlive this. Linear.
  TriangleFans(std::size_t vertex_count, std::span<const Index> corners);

  std::size_t vertex_count() const { return first_.size() - 1; }

  /// Corners at a vertex, ascending.
  std::span<const Index> at(std::size_t vertex) const {
    return {corners_at_.data() + first_[vertex], corners_at_.data() + first_[vertex + 1]};
  }

  /// The vertices after and before a corner's, around its triangle.
  Index next(Index corner) const { return corners_[corner % 3 == 2 ? corner - 2 : corner + 1]; }
  Index previous(Index corner) const { return corners_[corner % 3 == 0 ? corner + 2 : corner - 1]; }

  /// Broken where an edge has more than two triangles or two that disagree, or where several fans meet.
  Link link(std::size_t vertex) const;

  /// Of all vertices, on several threads.
  std::vector<Link> links(int threads, Progress& progress) const;

 private:
  std::span<const Index> corners_;
  std::vector<Index> first_, corners_at_;
};

/// Rims through vertices whose links are paths.
std::size_t open_loop_count(const TriangleFans& fans, std::span<const TriangleFans::Link> links);

}  // namespace croquis
