// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A sparse matrix that is written row by row.
class SparseRows {
 public:
  using Entry = std::pair<Index, double>;  ///< column and value

  /// How many there are.
  int size() const { return size_; }

  /// @param row entries in any order; those of one column are summed
  template <typename Row = std::initializer_list<Entry>>
  void add(const Row& row) {
    for (const auto& [column, value] : row) entries_.emplace_back(size_, static_cast<int>(column), value);
    ++size_;
  }

  Eigen::SparseMatrix<double> matrix(std::size_t columns) const {
    Eigen::SparseMatrix<double> result(size_, static_cast<Eigen::Index>(columns));
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }

 private:
  int size_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace croquis
