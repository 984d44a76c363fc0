// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace croquis::test {

/// Repeatable numbers (splitmix64, Steele, Lea and Flood 2014). The standard's distributions may give other values
/// with another library; these are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// In [0,1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  double between(double low, double high) { return low + (high - low) * unit(); }

  /// In [0,count); count > 0.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits() % count); }

 private:
  std::uint64_t state_;
};

}  // namespace croquis::test
