// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Cosine of a triangle's smallest angle, which lies opposite to its shortest side: 1/2 to 1, and 1 where two corners
/// are the same.
inline double sharpest_cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<double, 3> square{(b - c).squaredNorm(), (c - a).squaredNorm(), (a - b).squaredNorm()};
  std::sort(square.begin(), square.end());
  const double sides = std::sqrt(square[1] * square[2]);
  return sides > 0 ? (square[1] + square[2] - square[0]) / (2 * sides) : 1;
}

/// Triangles with a small angle, in the order in which they got it. Each is looked at when its turn comes, and again
/// when it was added since.
class SlenderTriangles {
 public:
  /// @param least_cosine of the smallest angle: triangles with less aren't added
  /// @param most_looks   in all; never met, a bound against endless changes
  SlenderTriangles(std::size_t count, double least_cosine, std::size_t most_looks)
      : waits_(count, 0), least_cosine_(least_cosine), most_looks_(most_looks) {}

  void add(Index triangle, double cosine) {
    if (cosine < least_cosine_ || waits_[triangle] != 0) return;
    waits_[triangle] = 1;
    waiting_.push_back(triangle);
  }

  std::optional<Index> next() {
    if (looks_ == std::min(waiting_.size(), most_looks_)) return std::nullopt;
    const Index triangle = waiting_[looks_++];
    waits_[triangle] = 0;
    return triangle;
  }

 private:
  std::vector<Index> waiting_;
  std::vector<std::uint8_t> waits_;  ///< per triangle
  double least_cosine_;
  std::size_t most_looks_, looks_ = 0;
};

inline std::size_t corner_of(const std::array<Index, 3>& corners, Index v) {
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

inline bool has_corner(const std::array<Index, 3>& corners, Index v) { return corners[corner_of(corners, v)] == v; }

}  // namespace croquis::silhouette
