// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/band_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

using Triangle = std::array<Index, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_states = 4'000'000;

/// Two chains of points to be joined, both from their first point on: the left one runs along its rim, the right one
/// against it. Edges join (i, j) = left[i], right[j]; a step along either side adds a triangle.
class Band {
 public:
  Band(const RimPolygon& rims, std::vector<Index> left, std::vector<Index> right, BandCost cost)
      : rims_(rims), left_(std::move(left)), right_(std::move(right)), cost_(cost) {}

  /// @param first, last how many points of each side lie before the first edge and behind the last one: the band's
  ///        ends are edges (0) or corners where both sides meet (1)
  std::optional<std::vector<Triangle>> run(std::size_t margin, Progress& progress) {
    begin_ = margin;
    rows_ = left_.size() - 2 * margin;
    columns_ = right_.size() - 2 * margin;
    if (rows_ * columns_ > most_states) return greedy();
    return by_table(progress);
  }

 private:
  Index left(std::size_t i) const { return left_[begin_ + i]; }
  Index right(std::size_t j) const { return right_[begin_ + j]; }
  Triangle along_left(std::size_t i, std::size_t j) const { return {left(i), left(i + 1), right(j)}; }
  Triangle along_right(std::size_t i, std::size_t j) const { return {left(i), right(j + 1), right(j)}; }

  double squared_length(std::size_t i, std::size_t j) const {
    return (rims_.points[left(i)] - rims_.points[right(j)]).squaredNorm();
  }

  /// Of going on to the edge (i, j) over a triangle.
  double cost_of(const Triangle& t, std::size_t i, std::size_t j) const {
    if (rims_.is_blocked(left(i), right(j)) && !is_end(i, j)) return infinite;
    const double area = triangle_cost(rims_.points[t[0]], rims_.points[t[1]], rims_.points[t[2]]);
    return cost_ == BandCost::Area || area == infinite ? area : squared_length(i, j);
  }

  /// The first edge of a closed band comes again at its end.
  bool is_end(std::size_t i, std::size_t j) const { return begin_ == 0 && i + 1 == rows_ && j + 1 == columns_; }

  std::optional<std::vector<Triangle>> by_table(Progress& progress) {
    std::vector<double> best(rows_ * columns_, infinite);
    std::vector<std::uint8_t> came_along_left(rows_ * columns_, 0);
    best[0] = 0;
    for (std::size_t i = 0; i < rows_; ++i) {
      progress.check();
      for (std::size_t j = 0; j < columns_; ++j) {
        const std::size_t at = i * columns_ + j;
        if (i > 0) best[at] = best[at - columns_] + cost_of(along_left(i - 1, j), i, j);
        came_along_left[at] = best[at] < infinite ? 1 : 0;
        if (j == 0) continue;
        const double other = best[at - 1] + cost_of(along_right(i, j - 1), i, j);
        if (!(other < best[at]) && !(i == 0)) continue;
        best[at] = other;
        came_along_left[at] = 0;
      }
    }
    if (!(best.back() < infinite)) return std::nullopt;
    std::vector<Triangle> triangles;
    std::size_t i = rows_ - 1, j = columns_ - 1;
    while (i + j > 0) {
      if (came_along_left[i * columns_ + j] != 0) {
        triangles.push_back(along_left(--i, j));
      } else {
        triangles.push_back(along_right(i, --j));
      }
    }
    return with_corners(std::move(triangles));
  }

  std::optional<std::vector<Triangle>> greedy() const {
    std::vector<Triangle> triangles;
    std::size_t i = 0, j = 0;
    while (i + j + 2 < rows_ + columns_) {
      const double on_left = i + 1 < rows_ ? cost_of(along_left(i, j), i + 1, j) : infinite;
      const double on_right = j + 1 < columns_ ? cost_of(along_right(i, j), i, j + 1) : infinite;
      if (on_left == infinite && on_right == infinite) return std::nullopt;
      const bool goes_left =
          on_right == infinite || (on_left < infinite && squared_length(i + 1, j) <= squared_length(i, j + 1));
      triangles.push_back(goes_left ? along_left(i, j) : along_right(i, j));
      ++(goes_left ? i : j);
    }
    return with_corners(std::move(triangles));
  }

  /// Where both sides begin and end in one point a triangle more.
  std::optional<std::vector<Triangle>> with_corners(std::vector<Triangle> triangles) const {
    if (begin_ == 0) return triangles;
    const Triangle first = {left_.front(), left(0), right(0)};
    const Triangle last = {left(rows_ - 1), left_.back(), right(columns_ - 1)};
    for (const Triangle& t : {first, last}) {
      if (triangle_cost(rims_.points[t[0]], rims_.points[t[1]], rims_.points[t[2]]) == infinite) return std::nullopt;
      triangles.push_back(t);
    }
    if (rims_.is_blocked(left(0), right(0))) return std::nullopt;
    return triangles;
  }

  const RimPolygon& rims_;
  std::vector<Index> left_, right_;
  BandCost cost_;
  std::size_t begin_ = 0, rows_ = 0, columns_ = 0;
};

/// The points of each loop that are nearest to each other. Quadratic.
std::pair<Index, Index> shortest_edge(const RimPolygon& rims) {
  std::pair<Index, Index> best{0, rims.loop_ends[0]};
  double shortest = infinite;
  for (Index a = 0; a < rims.loop_ends[0]; ++a) {
    for (Index b = rims.loop_ends[0]; b < rims.loop_ends[1]; ++b) {
      const double squared = (rims.points[a] - rims.points[b]).squaredNorm();
      if (!(squared < shortest) || rims.is_blocked(a, b)) continue;
      shortest = squared;
      best = {a, b};
    }
  }
  return best;
}

std::pair<Index, Index> farthest_points(const RimPolygon& rim) {
  std::pair<Index, Index> best{0, 1};
  double longest = -1;
  for (Index a = 0; a < rim.points.size(); ++a) {
    for (Index b = a + 1; b < rim.points.size(); ++b) {
      const double squared = (rim.points[a] - rim.points[b]).squaredNorm();
      if (!(squared > longest)) continue;
      longest = squared;
      best = {a, b};
    }
  }
  return best;
}

}  // namespace

std::optional<std::vector<Triangle>> band_triangulation(const RimPolygon& rims, BandCost cost, Progress& progress) {
  if (rims.loop_count() != 2) return std::nullopt;
  const Index first = rims.loop_ends[0], second = rims.loop_ends[1] - first;
  const auto [a, b] = shortest_edge(rims);
  std::vector<Index> left, right;
  for (Index i = 0; i <= first; ++i) left.push_back((a + i) % first);
  for (Index j = 0; j <= second; ++j) right.push_back(first + (b - first + second - j % second) % second);
  return Band(rims, std::move(left), std::move(right), cost).run(0, progress);
}

std::optional<std::vector<Triangle>> zip_triangulation(const RimPolygon& rim, BandCost cost, Progress& progress) {
  const auto count = static_cast<Index>(rim.points.size());
  if (rim.loop_count() != 1 || count < 4) return std::nullopt;
  const auto [a, b] = farthest_points(rim);
  if (b - a < 2 || count - (b - a) < 2) return std::nullopt;
  std::vector<Index> left, right;
  for (Index i = a; i <= b; ++i) left.push_back(i);
  for (Index j = 0; j <= count - (b - a); ++j) right.push_back((a + count - j) % count);
  return Band(rim, std::move(left), std::move(right), cost).run(1, progress);
}

}  // namespace croquis::hole_filling
