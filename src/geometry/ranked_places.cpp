// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/ranked_places.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace croquis {
namespace {

/// A point's coordinate along one axis.
struct RankedPlace {
  double coordinate;
  Index point;
};

/// So few are sorted by insertion.
constexpr std::ptrdiff_t few = 16;

void sort_by_coordinate(std::span<RankedPlace> items) {
  const auto is_less = [](const RankedPlace& a, const RankedPlace& b) { return a.coordinate < b.coordinate; };
  if (std::ssize(items) > few) return std::sort(items.begin(), items.end(), is_less);
  for (std::size_t i = 1; i < items.size(); ++i) {
    const RankedPlace item = items[i];
    std::size_t place = i;
    for (; place > 0 && is_less(item, items[place - 1]); --place) items[place] = items[place - 1];
    items[place] = item;
  }
}

/// Points by ascending coordinate: as many buckets as points, evenly over their range, and each of these sorted. Equal
/// coordinates come in any order.
std::vector<RankedPlace> sorted_along(std::span<const Vec3> positions, Eigen::Index axis) {
  double low = positions.front()[axis], high = low;
  for (const Vec3& p : positions) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
  const double scale = static_cast<double>(positions.size() - 1) / (high - low);
  const double buckets_per_length = std::isnormal(scale) && std::isfinite(high - low) ? scale : 0;
  const auto bucket = [&](double coordinate) {
    return std::min(static_cast<std::size_t>((coordinate - low) * buckets_per_length), positions.size() - 1);
  };
  // Shifted by one, so that placing the items turns beginnings into ends.
  std::vector<std::uint32_t> ends(positions.size() + 1, 0);
  for (const Vec3& p : positions) ++ends[bucket(p[axis]) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<RankedPlace> items(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    items[ends[bucket(positions[i][axis])]++] = {positions[i][axis], static_cast<Index>(i)};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    sort_by_coordinate({items.data() + begin, ends[i] - begin});
    begin = ends[i];
  }
  return items;
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

void add_ranks(const std::vector<RankedPlace>& items, std::size_t axis, std::vector<PackedPlace>& places) {
  const auto is_new = [&](std::size_t i) { return i > 0 && items[i].coordinate != items[i - 1].coordinate; };
  std::uint64_t different = 0;
  for (std::size_t i = 1; i < items.size(); ++i) different += is_new(i) ? 1U : 0U;
  const RankScale scale(different);
  std::uint64_t rank = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    rank += is_new(i) ? 1U : 0U;
    places[items[i].point] |= packed(scale(rank), axis);
  }
}

}  // namespace

std::vector<PackedPlace> ranked_places(std::span<const Vec3> positions) {
  std::vector<PackedPlace> places(positions.size(), 0);
  if (positions.empty()) return places;
  for (std::size_t axis = 0; axis < 3; ++axis)
    add_ranks(sorted_along(positions, static_cast<Eigen::Index>(axis)), axis, places);
  return places;
}

}  // namespace croquis
