// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/level_geometry.h"

#include <Eigen/Geometry>

#include "croquis/base/parallel.h"
#include "croquis/geometry/mesh_tags.h"

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

Vec3 unit_or_zero(const Vec3& vector) {
  constexpr double shortest = 1e-150;  // below, the square is no longer a normal number
  const double length = vector.norm();
  return length > shortest ? Vec3(vector / length) : Vec3(Vec3::Zero());
}

std::vector<double> edge_sharpness(const Level& level) {
  std::vector<double> sharpness(level.topology.edge_count(), 0);
  for (const SharpEdge& sharp : level.sharp) sharpness[sharp.edge] = sharp.sharpness;
  for (const Index corner : level.boundary) sharpness[level.topology.corner_edge[corner]] = infinite_sharpness;
  return sharpness;
}

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
