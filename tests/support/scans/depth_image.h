// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::test {

/// What a scanner far away sees: for every node of a grid across its view, the depth of the surface nearest to it.
class DepthImage {
 public:
  /// @param mesh triangles; @param towards the scanner, any length but 0; @param spacing of the grid, model units
  DepthImage(const PolyMesh& mesh, const Vec3& towards, double spacing);

  const Vec3& towards() const { return axes_[2]; }

  /// Whether nothing lies before the point by more than `slack`.
  bool shows(const Vec3& point, double slack) const;

  /// The grid's triangles, without those with an edge of more than four times the spacing.
  PolyMesh surface() const;

 private:
  void draw(const Vec3& a, const Vec3& b, const Vec3& c);
  Vec3 in_view(const Vec3& point) const;  // in grid units across, model units towards the scanner
  std::size_t node(Index column, Index row) const { return std::size_t{row} * columns_ + column; }

  double spacing_;
  std::vector<Vec3> axes_;  // right, up, towards
  Vec3 corner_ = Vec3::Zero();
  Index columns_ = 0, rows_ = 0;
  std::vector<double> depth_;  // towards the scanner; -infinity where nothing is
};

}  // namespace croquis::test
