// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/rational_cubic.h"
#include "document/values/vector_bytes.h"

namespace croquis {

/// The bytes of a rational cubic: counts are checked with it.
inline constexpr std::size_t rational_bytes = 16 * sizeof(double);

inline void write_rational(const RationalCubic& cubic, ByteWriter& writer) {
  for (const Vec3& point : cubic.points) write_numbers(point, writer);
  for (const double weight : cubic.weights) writer.number(weight);
}

/// @throws BadBytes where a point can't be used or a weight isn't positive
inline RationalCubic read_rational(ByteReader& reader) {
  RationalCubic cubic;
  for (Vec3& point : cubic.points) point = read_usable<Vec3>(reader);
  for (double& weight : cubic.weights) {
    weight = reader.number<double>();
    if (!(weight > 0 && weight <= 1e300)) throw BadBytes("a curve's weight is not positive");
  }
  return cubic;
}

inline void hash_rational(const RationalCubic& cubic, ContentHasher& hasher) {
  for (const Vec3& point : cubic.points) hash_numbers(point, hasher);
  for (const double weight : cubic.weights) hasher.add(weight);
}

inline void write_rationals(const std::vector<RationalCubic>& cubics, ByteWriter& writer) {
  writer.count(cubics.size());
  for (const RationalCubic& cubic : cubics) write_rational(cubic, writer);
}

inline std::vector<RationalCubic> read_rationals(ByteReader& reader) {
  std::vector<RationalCubic> cubics(reader.count(rational_bytes));
  for (RationalCubic& cubic : cubics) cubic = read_rational(reader);
  return cubics;
}

inline void hash_rationals(const std::vector<RationalCubic>& cubics, ContentHasher& hasher) {
  hasher.add(cubics.size());
  for (const RationalCubic& cubic : cubics) hash_rational(cubic, hasher);
}

}  // namespace croquis
