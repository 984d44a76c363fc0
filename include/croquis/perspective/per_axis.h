// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace croquis {

/// One of something for each of the axes x, y and z, which are numbered 0..2 everywhere.
template <typename T>
class PerAxis {
 public:
  PerAxis() = default;
  PerAxis(const T& x, const T& y, const T& z) : values_{x, y, z} {}

  T& operator[](int axis) { return values_[static_cast<std::size_t>(axis)]; }
  const T& operator[](int axis) const { return values_[static_cast<std::size_t>(axis)]; }

  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::array<T, 3> values_{};
};

}  // namespace croquis
