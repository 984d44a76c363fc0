// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spread_stars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

  /// Whether one triangle begins, and one ends, at each spoke: then they form closed rings. Without branches, which
  /// nothing predicts: what is compared beside the spokes is nobody's.
  bool closes() {
    const std::size_t end = (size_ + lanes - 1) / lanes * lanes;
    for (std::size_t i = size_; i < end; ++i) from_[i] = to_[i] = no_index;
    bool all_match = true;
    for (std::size_t i = 0; i < size_; ++i) {
      std::uint32_t beginning = 0, ending = 0;
      for (std::size_t j = 0; j < end; ++j) {
        beginning += from_[j] == to_[i] ? 1U : 0U;
        ending += to_[j] == from_[i] ? 1U : 0U;
      }
      all_match &= beginning == 1 && ending == 1;
    }
    return all_match;
  }

  /// Of a star that closes; of fewer than three triangles it isn't. Rings that are seen from one side go round the
  /// middle at least once each: what goes round once is one ring.
  bool is_clearly_spread(const std::vector<Vec3>& positions, const Vec3& middle) const {
    if (size_ < 3) return false;
    Spokes from, to;
    double longest = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      from[i] = positions[from_[i]] - middle;
      to[i] = positions[to_[i]] - middle;
      longest = std::max(longest, from[i].squaredNorm());
    }
    if (!(longest < largest_square)) return false;
    // Seen along the sum of the normals. Any direction will do: this one is exact, whatever rounding went into it.
    Spokes normals;
    Vec3 direction = Vec3::Zero();
    for (std::size_t i = 0; i < size_; ++i) direction += normals[i] = from[i].cross(to[i]);
    const double margin = 4 * sign_margin * longest * direction.norm() + smallest_product;
    return faces_one_way(normals, direction, margin) && goes_round_once(from, to, direction, margin);
  }

 private:
  static constexpr std::size_t lanes = 8;
  static_assert(most_spokes % lanes == 0);

  using Spokes = std::array<Vec3, most_spokes>;

  bool faces_one_way(const Spokes& normals, const Vec3& direction, double margin) const {
    bool do_all = true;
    for (std::size_t i = 0; i < size_; ++i) do_all &= normals[i].dot(direction) > margin;
    return do_all;
  }

  /// Each triangle turns by less than half a turn, so it crosses a line through the middle once or not at all: that is
  /// two crossings in one turn, four in two.
  bool goes_round_once(const Spokes& from, const Spokes& to, const Vec3& direction, double margin) const {
    const Vec3 across = (3 * from[0] + to[0]).cross(direction);
    int crossings = 0;
    bool are_clear = true;
    for (std::size_t i = 0; i < size_; ++i) {
      const double before = across.dot(from[i]), behind = across.dot(to[i]);
      are_clear &= std::abs(before) > margin;  // each spoke is one triangle's first
      crossings += (before > 0) != (behind > 0) ? 1 : 0;
    }
    return are_clear && crossings == 2;
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
    if (star.closes()) is_spread[vertex] = star.is_clearly_spread(positions, positions[vertex]) ? 1 : 0;
  }
  return is_spread;
}

}  // namespace croquis
