// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "croquis/base/limits.h"
#include "croquis/document/byte_stream.h"
#include "croquis/document/content_hash.h"

namespace croquis {

/// The numbers of a vector or matrix, column by column; not how many.
template <typename Derived>
void write_numbers(const Eigen::DenseBase<Derived>& numbers, ByteWriter& writer) {
  for (const double value : numbers.derived().reshaped()) writer.number(value);
}

template <typename Matrix>
Matrix read_numbers(ByteReader& reader) {
  Matrix numbers;
  for (double& value : numbers.reshaped()) value = reader.number<double>();
  return numbers;
}

/// @throws BadBytes where a number can't be used (limits.h)
template <typename Matrix>
Matrix read_usable(ByteReader& reader) {
  const Matrix numbers = read_numbers<Matrix>(reader);
  if (!are_usable_numbers(numbers.reshaped())) throw BadBytes(std::string("a number ") + unusable_words);
  return numbers;
}

template <typename Derived>
void hash_numbers(const Eigen::DenseBase<Derived>& numbers, ContentHasher& hasher) {
  for (const double value : numbers.derived().reshaped()) hasher.add(value);
}

}  // namespace croquis
