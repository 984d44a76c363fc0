// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spread_stars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "geometry/clear_sign.h"

namespace croquis {
namespace {

/// Larger stars are left to the comparison of pairs.
constexpr std::size_t most_spokes = 16;

/// The triangles at a vertex: from each spoke to the one after it.
class Star {
 public:
  void clear() { size_ = 0; }

  /// At most most_spokes times.
  void add(Index from, Index to) {
    from_[size_] = from;
    to_[size_++] = to;
  }

  /// Brings the triangles into an order in which each begins where the one before it ends.
  /// @return whether they close in one ring
  bool close_ring() {
    for (std::size_t i = 0; i + 1 < size_; ++i) {
      std::size_t j = i + 1;
      while (j < size_ && from_[j] != to_[i]) ++j;
      if (j == size_) return false;
      std::swap(from_[i + 1], from_[j]);
      std::swap(to_[i + 1], to_[j]);
    }
    return to_[size_ - 1] == from_[0];
  }

  /// Of a closed ring; of fewer than three triangles it isn't.
  bool is_clearly_spread(const std::vector<Vec3>& positions, const Vec3& middle) const {
    if (size_ < 3) return false;
    Spokes spokes;
    double longest = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      spokes[i] = positions[from_[i]] - middle;
      longest = std::max(longest, spokes[i].squaredNorm());
    }
    if (!(longest < largest_square)) return false;
    spokes[size_] = spokes[0];
    // Seen along the sum of the normals. Any direction will do: this one is exact, whatever rounding went into it.
    Spokes normals;
    Vec3 direction = Vec3::Zero();
    for (std::size_t i = 0; i < size_; ++i) direction += normals[i] = spokes[i].cross(spokes[i + 1]);
    const double margin = 4 * sign_margin * longest * direction.norm() + smallest_product;
    return faces_one_way(normals, direction, margin) && goes_round_once(spokes, direction, margin);
  }

 private:
  using Spokes = std::array<Vec3, most_spokes + 1>;

  bool faces_one_way(const Spokes& normals, const Vec3& direction, double margin) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (!(normals[i].dot(direction) > margin)) return false;
    }
    return true;
  }

  /// Each triangle turns by less than half a turn, so it crosses a line through the middle once or not at all: that is
  /// two crossings in one turn, four in two.
  bool goes_round_once(const Spokes& spokes, const Vec3& direction, double margin) const {
    const Vec3 across = (3 * spokes[0] + spokes[1]).cross(direction);
    int crossings = 0;
    double last = across.dot(spokes[size_ - 1]);
    for (std::size_t i = 0; i < size_; ++i) {
      const double side = across.dot(spokes[i]);
      if (!(std::abs(side) > margin)) return false;
      crossings += (side > 0) != (last > 0) ? 1 : 0;
      last = side;
    }
    return crossings == 2;
  }

  std::array<Index, most_spokes> from_, to_;
  std::size_t size_ = 0;
};

/// The corners at each vertex behind one another: 3 t + i is corner i of triangle t.
struct CornersByVertex {
  CornersByVertex(std::size_t vertex_count, std::span<const MeetingTriangle> triangles)
      : ends(vertex_count + 1, 0), corners(3 * triangles.size()) {
    // Shifted by one, so that placing the corners turns beginnings into ends.
    for (const MeetingTriangle& triangle : triangles) {
      for (const Index vertex : triangle.vertices) ++ends[vertex + std::size_t{1}];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    Index corner = 0;
    for (const MeetingTriangle& triangle : triangles) {
      for (const Index vertex : triangle.vertices) corners[ends[vertex]++] = corner++;
    }
  }

  std::span<const Index> at(Index vertex) const {
    const std::size_t begin = vertex == 0 ? 0 : ends[vertex - 1];
    return {corners.data() + begin, corners.data() + ends[vertex]};
  }

  std::vector<Index> ends;  ///< per vertex
  std::vector<Index> corners;
};

}  // namespace

std::vector<char> spread_stars(const std::vector<Vec3>& positions, std::span<const MeetingTriangle> triangles) {
  constexpr std::array<std::array<std::size_t, 2>, 3> others = {{{1, 2}, {2, 0}, {0, 1}}};
  const CornersByVertex corners(positions.size(), triangles);
  std::vector<char> is_spread(positions.size(), 0);
  Star star;
  for (Index vertex = 0; vertex < positions.size(); ++vertex) {
    const std::span<const Index> around = corners.at(vertex);
    if (around.size() < 3 || around.size() > most_spokes) continue;
    star.clear();
    for (const Index corner : around) {
      const auto& v = triangles[corner / 3].vertices;
      const auto [next, previous] = others[corner % 3];
      star.add(v[next], v[previous]);
    }
    if (star.close_ring()) is_spread[vertex] = star.is_clearly_spread(positions, positions[vertex]) ? 1 : 0;
  }
  return is_spread;
}

}  // namespace croquis
