// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

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
