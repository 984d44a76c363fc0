// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "croquis/geometry/vector.h"
#include "croquis/subdivision/level.h"

namespace croquis::subdivision {

/// Of unit length, or zero where the vector is too short to have a direction.
Vec3 unit_or_zero(const Vec3& vector);

/// Sharpness of each edge, 0 where there is no tag, infinite on the boundary.
std::vector<double> edge_sharpness(const Level& level);

/// Calls use(corner) for the corners of a vertex counter-clockwise, from its `vertex_corner`.
template <typename Use>
void for_each_corner(const HalfEdges& mesh, const CornerFaces& around, Index vertex, Use&& use) {
  const Index start = mesh.vertex_corner[vertex];
  Index corner = start;
  do {
    use(corner);
    corner = mesh.twin[around.previous(corner)];
  } while (corner != no_index && corner != start);
}

/// Rows of weights: value i = sum of weights times the values at columns, over [offsets[i], offsets[i+1]).
struct WeightRows {
  std::vector<Index> offsets = {0};
  std::vector<Index> columns;
  std::vector<double> weights;

  std::size_t size() const { return offsets.size() - 1; }

  void add(Index column, double weight) {
    columns.push_back(column);
    weights.push_back(weight);
  }
  void end_row() { offsets.push_back(static_cast<Index>(columns.size())); }
};

/// Computes all rows; each by one thread in the rows' own order, so that the bits don't depend on the threads.
/// @param results one per row; @param threads >= 1
void apply(const WeightRows& rows, std::span<const Vec3> values, std::span<Vec3> results, int threads = 1);

using WeightMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Entries of the same row and column add up.
WeightMatrix to_matrix(const WeightRows& rows, std::size_t column_count);

}  // namespace croquis::subdivision
