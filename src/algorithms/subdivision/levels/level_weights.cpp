// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/level_weights.h"

#include <cstddef>
#include <vector>

namespace croquis::subdivision {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

void add(std::size_t row, Index column, double weight, Entries& entries) {
  entries.emplace_back(static_cast<int>(row), static_cast<int>(column), weight);
}

void add_row(const WeightRows& rows, std::size_t which, std::size_t row, Entries& entries) {
  for (Index i = rows.offsets[which]; i < rows.offsets[which + 1]; ++i) {
    add(row, rows.columns[i], rows.weights[i], entries);
  }
}

/// How much of the plain rule each own point keeps, by point.
std::vector<double> plain_shares(const Refinement& made) {
  std::vector<double> shares(made.origins.own_corners.kept_count(), 1);
  for (std::size_t i = 0; i < made.rules.adjusted_corner.size(); ++i) {
    shares[made.origins.own_corners.rank(made.rules.adjusted_corner[i])] = made.rules.plain_share[i];
  }
  return shares;
}

void add_plain_rows(const HalfEdges& old, const Refinement& made, const FaceMask& mask, Entries& entries) {
  const std::vector<double> shares = plain_shares(made);
  for (std::size_t face = 0; face < old.face_count(); ++face) {
    const auto corners = old.face(face);
    const std::size_t n = corners.size();
    const std::vector<double> row = mask.row(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Index point = made.level.topology.corner_vertex[old.face_offsets[face] + i];
      if (point >= shares.size() || shares[point] == 0) continue;
      for (std::size_t j = 0; j < n; ++j) add(point, corners[(i + j) % n], shares[point] * row[j], entries);
    }
  }
}

}  // namespace

Eigen::SparseMatrix<double, Eigen::RowMajor> level_weights(const HalfEdges& old, const Refinement& made,
                                                           const FaceMask& mask) {
  Entries entries;
  add_plain_rows(old, made, mask, entries);
  const PointRules& rules = made.rules;
  for (std::size_t i = 0; i < rules.adjusted.size(); ++i) {
    add_row(rules.adjusted, i, made.origins.own_corners.rank(rules.adjusted_corner[i]), entries);
  }
  const std::size_t own = made.origins.own_corners.kept_count();
  for (std::size_t i = 0; i < rules.listed.size(); ++i) add_row(rules.listed, i, own + i, entries);
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(static_cast<Eigen::Index>(made.level.topology.vertex_count()),
                                                      static_cast<Eigen::Index>(old.vertex_count()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace croquis::subdivision
