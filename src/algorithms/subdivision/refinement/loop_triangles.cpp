// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/loop_triangles.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>

namespace croquis::subdivision {
namespace {

constexpr std::size_t largest_fan = 64;

std::uint64_t pair_key(Index a, Index b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low} << 32U) | high;
}

class Cutter {
 public:
  explicit Cutter(const HalfEdges& mesh) : mesh_(mesh), valence_(mesh.vertex_count(), 0) {
    for (const Index corner : mesh.edge_corner) {
      const Index other = twin_end(corner);
      joined_.insert(pair_key(mesh.corner_vertex[corner], other));
      ++valence_[mesh.corner_vertex[corner]];
      ++valence_[other];
    }
  }

  LoopTriangles cut() {
    for (Index face = 0; face < mesh_.face_count(); ++face) cut(face);
    return std::move(result_);
  }

 private:
  /// The vertex at the far end of the half-edge.
  Index twin_end(Index corner) const {
    const auto after = std::upper_bound(mesh_.face_offsets.begin(), mesh_.face_offsets.end(), corner);
    return corner + 1 == *after ? mesh_.corner_vertex[*(after - 1)] : mesh_.corner_vertex[corner + 1];
  }

  void add(Index a, Index b, Index c, Index face) {
    result_.corners.insert(result_.corners.end(), {a, b, c});
    result_.source_face.push_back(face);
  }

  void cut(Index face) {
    const auto vertices = mesh_.face(face);
    if (vertices.size() == 3) return add(vertices[0], vertices[1], vertices[2], face);
    ++result_.cut_faces;
    const std::optional<std::size_t> tip = vertices.size() <= largest_fan ? best_tip(vertices) : std::nullopt;
    if (tip) {
      add_fan(vertices, *tip, face);
    } else {
      add_centre(vertices, face);
    }
  }

  /// The corner whose fan of diagonals makes the least sum of squared valences, the first of several.
  std::optional<std::size_t> best_tip(std::span<const Index> vertices) const {
    const std::size_t n = vertices.size();
    std::optional<std::size_t> best;
    std::size_t least = 0;
    for (std::size_t tip = 0; tip < n; ++tip) {
      bool free = true;
      std::size_t cost = (n - 3) * (2 * valence_[vertices[tip]] + n - 3);
      for (std::size_t i = 2; i + 1 < n; ++i) {
        const Index other = vertices[(tip + i) % n];
        free = free && !joined_.contains(pair_key(vertices[tip], other));
        cost += 2 * valence_[other] + 1;
      }
      if (!free || (best && cost >= least)) continue;
      best = tip;
      least = cost;
    }
    return best;
  }

  void add_fan(std::span<const Index> vertices, std::size_t tip, Index face) {
    const std::size_t n = vertices.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const Index a = vertices[tip], b = vertices[(tip + i) % n];
      add(a, b, vertices[(tip + i + 1) % n], face);
      if (i == 1) continue;
      joined_.insert(pair_key(a, b));
      ++valence_[a];
      ++valence_[b];
    }
  }

  void add_centre(std::span<const Index> vertices, Index face) {
    const auto centre = static_cast<Index>(mesh_.vertex_count() + result_.centred_faces.size());
    result_.centred_faces.push_back(face);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      add(vertices[i], vertices[(i + 1) % vertices.size()], centre, face);
      ++valence_[vertices[i]];
    }
  }

  const HalfEdges& mesh_;
  std::vector<std::size_t> valence_;
  std::unordered_set<std::uint64_t> joined_;  // asked, never listed
  LoopTriangles result_;
};

}  // namespace

LoopTriangles loop_triangles(const HalfEdges& mesh) { return Cutter(mesh).cut(); }

}  // namespace croquis::subdivision
