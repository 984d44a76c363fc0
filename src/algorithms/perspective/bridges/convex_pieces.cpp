// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/bridges/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace croquis {
namespace {

constexpr double straight_sine = 1e-7;  // corners that turn to the right by less are straight

bool is_convex_corner(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 arriving = at - before, leaving = after - at;
  return cross(arriving, leaving) >= -straight_sine * arriving.norm() * leaving.norm();
}

bool is_convex(std::span<const Vec2> points, std::span<const Index> polygon) {
  const std::size_t n = polygon.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &before = points[polygon[i]], &at = points[polygon[(i + 1) % n]], &after = points[polygon[(i + 2) % n]];
    if (!is_convex_corner(before, at, after)) return false;
    const Vec2 arriving = at - before, leaving = after - at;
    turned += std::atan2(cross(arriving, leaving), arriving.dot(leaving));
  }
  return turned > 0 && turned < 7;  // once around, not twice
}

/// Whether the triangles from the polygon's first corner to all sides have an area.
bool sees_all_sides(std::span<const Vec2> points, std::span<const Index> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = points[polygon[i]] - points[polygon[0]], b = points[polygon[i + 1]] - points[polygon[0]];
    if (cross(a, b) <= straight_sine * a.norm() * b.norm()) return false;
  }
  return true;
}

bool begin_at_fan(std::span<const Vec2> points, std::vector<Index>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (sees_all_sides(points, polygon)) return true;
    std::ranges::rotate(polygon, polygon.begin() + 1);
  }
  return false;
}

class PieceMerger {
 public:
  PieceMerger(std::span<const Vec2> points, std::span<const std::array<Index, 3>> triangles) : points_(points) {
    for (const auto& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) piece_of_[{triangle[i], triangle[(i + 1) % 3]}] = pieces_.size();
      pieces_.emplace_back(triangle.begin(), triangle.end());
    }
  }

  std::vector<std::vector<Index>> run() {
    for (const Diagonal& diagonal : diagonals()) remove(diagonal[0], diagonal[1]);
    std::erase_if(pieces_, [](const auto& piece) { return piece.empty(); });
    return std::move(pieces_);
  }

 private:
  using Diagonal = std::array<Index, 2>;

  /// The longest first; equal ones in the order of their vertices.
  std::vector<Diagonal> diagonals() const {
    std::vector<std::tuple<double, Index, Index>> found;
    for (const auto& [side, piece] : piece_of_) {
      const auto [a, b] = side;
      if (a < b && piece_of_.contains({b, a})) found.emplace_back(-(points_[a] - points_[b]).norm(), a, b);
    }
    std::ranges::sort(found);
    std::vector<Diagonal> result;
    for (const auto& [length, a, b] : found) result.push_back({a, b});
    return result;
  }

  /// The piece's vertices from b on, round to a: those of its side (a, b) are last and first.
  std::vector<Index> from_side(const std::vector<Index>& piece, Index a, Index b) const {
    std::vector<Index> result = piece;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i] != a || piece[(i + 1) % piece.size()] != b) continue;
      std::ranges::rotate(result, result.begin() + static_cast<std::ptrdiff_t>((i + 1) % piece.size()));
      break;
    }
    return result;
  }

  void remove(Index a, Index b) {
    const std::size_t left = piece_of_.at({a, b}), right = piece_of_.at({b, a});
    if (left == right) return;
    const std::vector<Index> first = from_side(pieces_[left], a, b);    // b … a
    const std::vector<Index> second = from_side(pieces_[right], b, a);  // a … b
    const bool convex = is_convex_corner(points_[second[second.size() - 2]], points_[b], points_[first[1]]) &&
                        is_convex_corner(points_[first[first.size() - 2]], points_[a], points_[second[1]]);
    if (!convex) return;
    std::vector<Index> joined = first;
    joined.insert(joined.end(), second.begin() + 1, second.end() - 1);
    if (std::set<Index>(joined.begin(), joined.end()).size() < joined.size()) return;
    if (!begin_at_fan(points_, joined)) return;
    for (std::size_t i = 0; i + 1 < second.size(); ++i) piece_of_[{second[i], second[i + 1]}] = left;
    piece_of_.erase({a, b});
    piece_of_.erase({b, a});
    pieces_[left] = std::move(joined);
    pieces_[right].clear();
  }

  std::span<const Vec2> points_;
  std::vector<std::vector<Index>> pieces_;
  std::map<std::array<Index, 2>, std::size_t> piece_of_;  ///< by the directed side
};

}  // namespace

std::vector<std::vector<Index>> convex_pieces(std::span<const Vec2> points,
                                              std::span<const std::array<Index, 3>> triangles) {
  return PieceMerger(points, triangles).run();
}

bool make_fan(std::span<const Vec2> points, std::vector<Index>& polygon) {
  return is_convex(points, polygon) && begin_at_fan(points, polygon);
}

}  // namespace croquis
