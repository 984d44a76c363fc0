// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/ranked_places.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

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

/// Steps between the bounds of the triangles. Rounding keeps the order of coordinates.
class EvenSteps {
 public:
  EvenSteps(const Vec3& low, const Vec3& high) : low_(low) {
    for (int axis = 0; axis < 3; ++axis) {
      const double scale = most / (high[axis] - low[axis]);
      per_length_[axis] = std::isnormal(scale) && std::isfinite(high[axis] - low[axis]) ? scale : 0;
    }
  }

  PackedPlace operator()(const Vec3& point) const {
    PackedPlace place = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      const double steps = (point[k] - low_[k]) * per_length_[k];  // no number at all where no triangle is
      place |= packed(static_cast<std::uint64_t>(steps > 0 ? std::min(steps, most) : 0), axis);
    }
    return place;
  }

  /// Along the axis where that is least.
  double steps_along(const Vec3& size) const { return size.cwiseProduct(per_length_).minCoeff(); }

 private:
  static constexpr double most = (1 << packed_bits) - 1;

  Vec3 low_, per_length_;
};

/// Every so many triangles one is measured.
constexpr std::size_t measured_distance = 32;

/// So many steps long is the box of a usual triangle along each axis at least: then hardly any boxes overlap by
/// rounding alone.
constexpr double fewest_steps = 64;

/// None where they would be too coarse.
std::optional<EvenSteps> even_steps(const std::vector<Vec3>& positions, std::span<const MeetingTriangle> triangles) {
  if (triangles.empty()) return std::nullopt;
  Vec3 low = positions[triangles.front().vertices.front()], high = low, sizes = Vec3::Zero();
  double measured = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t].vertices;
    const Vec3 least = positions[a].cwiseMin(positions[b]).cwiseMin(positions[c]);
    const Vec3 greatest = positions[a].cwiseMax(positions[b]).cwiseMax(positions[c]);
    low = low.cwiseMin(least), high = high.cwiseMax(greatest);
    if (t % measured_distance != 0) continue;
    sizes += greatest - least;
    ++measured;
  }
  const EvenSteps steps(low, high);
  return steps.steps_along(sizes / measured) >= fewest_steps ? std::optional(steps) : std::nullopt;
}

}  // namespace

std::vector<PackedPlace> ranked_places(std::span<const Vec3> positions) {
  std::vector<PackedPlace> places(positions.size(), 0);
  if (positions.empty()) return places;
  for (std::size_t axis = 0; axis < 3; ++axis)
    add_ranks(sorted_along(positions, static_cast<Eigen::Index>(axis)), axis, places);
  return places;
}

std::vector<PackedPlace> places_for_boxes(const std::vector<Vec3>& positions,
                                          std::span<const MeetingTriangle> triangles) {
  if (const auto steps = even_steps(positions, triangles)) {
    std::vector<PackedPlace> places(positions.size());
    std::transform(positions.begin(), positions.end(), places.begin(), *steps);
    return places;
  }
  std::vector<std::uint8_t> is_used(positions.size(), 0);
  for (const MeetingTriangle& triangle : triangles) {
    for (const Index v : triangle.vertices) is_used[v] = 1;
  }
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_used[v] != 0) points.push_back(positions[v]);
  }
  const std::vector<PackedPlace> ranked = ranked_places(points);
  std::vector<PackedPlace> places(positions.size());
  std::size_t next = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_used[v] != 0) places[v] = ranked[next++];
  }
  return places;
}

}  // namespace croquis
