// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/weight_rows.h"

#include "croquis/base/parallel.h"

namespace croquis::subdivision {
namespace {

/// A thread for fewer rows costs more than it saves.
constexpr std::size_t least_rows_per_thread = 4096;

void apply_range(const WeightRows& rows, std::span<const Vec3> values, std::span<Vec3> results, std::size_t begin,
                 std::size_t end) {
  for (std::size_t row = begin; row < end; ++row) {
    Vec3 sum = Vec3::Zero();
    for (Index i = rows.offsets[row]; i < rows.offsets[row + 1]; ++i) {
      sum += rows.weights[i] * values[rows.columns[i]];
    }
    results[row] = sum;
  }
}

}  // namespace

void apply(const WeightRows& rows, std::span<const Vec3> values, std::span<Vec3> results, int threads) {
  for_each_part(rows.size(), even_grain(rows.size(), threads, least_rows_per_thread), threads,
                [&](std::size_t begin, std::size_t end) { apply_range(rows, values, results, begin, end); });
}

WeightMatrix to_matrix(const WeightRows& rows, std::size_t column_count) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(rows.columns.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (Index i = rows.offsets[row]; i < rows.offsets[row + 1]; ++i) {
      entries.emplace_back(static_cast<int>(row), static_cast<int>(rows.columns[i]), rows.weights[i]);
    }
  }
  WeightMatrix matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(column_count));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace croquis::subdivision
