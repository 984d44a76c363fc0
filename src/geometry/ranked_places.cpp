// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/ranked_places.h"

#include <bit>
#include <cstdint>

#include "geometry/radix_order.h"

namespace croquis {
namespace {

/// A whole number that orders as the finite coordinate does; both zeros are the same.
std::uint64_t ordered_key(double coordinate) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  if (coordinate == 0) return sign;
  const auto bits = std::bit_cast<std::uint64_t>(coordinate);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Ranks from 0 to below 2^20, as far spread as they can be.
class RankScale {
 public:
  explicit RankScale(std::uint64_t different) {
    const auto needed = static_cast<unsigned>(std::bit_width(different));
    if (needed > packed_bits)
      drop_ = needed - packed_bits;
    else
      spread_ = packed_bits - needed;
  }
  std::uint64_t operator()(std::uint64_t rank) const { return (rank >> drop_) << spread_; }

 private:
  unsigned drop_ = 0;
  unsigned spread_ = 0;
};

void add_ranks(const std::vector<std::uint64_t>& keys, std::size_t axis, std::vector<PackedPlace>& places) {
  const std::vector<Index> order = radix_order(keys);
  std::uint64_t different = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (keys[order[i]] != keys[order[i - 1]]) ++different;
  const RankScale scale(different);
  std::uint64_t rank = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && keys[order[i]] != keys[order[i - 1]]) ++rank;
    places[order[i]] |= packed(scale(rank), axis);
  }
}

}  // namespace

std::vector<PackedPlace> ranked_places(std::span<const Vec3> positions) {
  std::vector<PackedPlace> places(positions.size(), 0);
  std::vector<std::uint64_t> keys(positions.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      keys[i] = ordered_key(positions[i][static_cast<Eigen::Index>(axis)]);
    add_ranks(keys, axis, places);
  }
  return places;
}

}  // namespace croquis
