// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/geometry/vector.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// cos and sin of a full turn's j-th of n parts, by integer reduction to an eighth and a series of plain arithmetic:
/// the same bits on every machine, and exact symmetry.
Vec2 unit_root(std::size_t j, std::size_t n);

/// Doo-Sabin's points of whole faces.
class FaceMask {
 public:
  explicit FaceMask(Weights weights);

  /// The weights of a face's corners in the point of its first: #n.
  std::vector<double> row(std::size_t n) const;

  /// The points of all corners of a face of n corners, in time O(n).
  ///
  /// Classical: mode k of the corners' discrete Fourier transform shrinks by 1 for k = 0, 1/2 for k = ±1 and 1/4 for
  /// the others, so a point is V/4 + 3/4 centroid + 1/4 of mode ±1.
  /// @param points, corners vertex of each corner; @param result #n
  void apply(const Vec3* points, std::span<const Index> corners, Vec3* result) const {
    if (corners.size() == 4) return apply_to_quad(points, corners.data(), result);
    apply_to_polygon(points, corners, result);
  }

 private:
  /// 9 3 3 1 in both forms of weights.
  static void apply_to_quad(const Vec3* points, const Index* corners, Vec3* result) {
    const Vec3 &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]], &d = points[corners[3]];
    for (int i = 0; i < 3; ++i) {
      const double ab = 0.75 * a[i] + 0.25 * b[i], ba = 0.75 * b[i] + 0.25 * a[i];
      const double cd = 0.75 * c[i] + 0.25 * d[i], dc = 0.75 * d[i] + 0.25 * c[i];
      result[0][i] = 0.75 * ab + 0.25 * dc;
      result[1][i] = 0.75 * ba + 0.25 * cd;
      result[2][i] = 0.75 * cd + 0.25 * ba;
      result[3][i] = 0.75 * dc + 0.25 * ab;
    }
  }

  void apply_to_polygon(const Vec3* points, std::span<const Index> corners, Vec3* result) const;
  void apply_average(const Vec3* points, std::span<const Index> corners, Vec3* result) const;
  Vec2 root(std::size_t j, std::size_t n) const;

  Weights weights_;
  std::vector<Vec2> roots_;  ///< of small n, one behind another
};

/// How the points of a level follow from those of the level before, where plain faces don't decide it.
struct PointRules {
  std::vector<Index> gap_faces;        ///< old faces of which not all corners have a point of their own, ascending
  std::vector<Index> adjusted_corner;  ///< old corners whose points differ from the plain rule, ascending
  std::vector<double> plain_share;     ///< for each of these how much of the plain point stays …
  WeightRows adjusted;                 ///< … and what comes to it
  WeightRows listed;                   ///< the points behind those of corners, in order
};

/// Rules beside and on tagged edges: presets differ here alone.
PointRules make_point_rules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask);

}  // namespace croquis::subdivision
