// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/jitter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Waves of the hand are a tenth to a third of what it draws; the differences see those of four times this share best.
constexpr double difference_share = 0.08;
// Smooth drawings have a quartile of less than the first; a jitter of 2 % of the object's diagonal has about the
// second.
constexpr double steady = 0.001;
constexpr double unsteady = 0.002;
// An unsteady hand draws all lines so; the edge of a cloud or of a leaf is uneven by itself. So the steadier lines
// count.
constexpr double steadiest_share = 0.25;
// The piece whose direction is taken then, as a share of the line's size.
constexpr double direction_share = 0.2;

// More crossings than this weren't made by an unsteady hand.
constexpr int most_crossings = 30;
// Nor is one nearer to an end than so many times what an end may miss.
constexpr double free_reach = 2;

/// Median size of the fourth differences, as a share of the line's size.
double unevenness(const CleanLine& line, double step) {
  const auto count = static_cast<Index>(line.points.size());
  const auto wanted = static_cast<Index>(std::max(2L, std::lround(difference_share * line.size / step)));
  const Index apart = std::min(wanted, (count - 1) / 5);
  if (apart == 0 || !(line.size > 0)) return 0;
  std::vector<double> sizes;
  const auto place = [&](Index i, Index steps) -> const Vec2& { return line.points[(i + steps * apart) % count]; };
  for (Index i = 0; i < (line.closed ? count : count - 4 * apart); ++i) {
    const Vec2 outer = place(i, 0) + place(i, 4);
    const Vec2 inner = place(i, 1) + place(i, 3);
    sizes.push_back((outer - 4 * inner + 6 * place(i, 2)).norm() / 16);
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle / line.size;
}

/// Outward direction of the straight line through the last `reach` of a line, places near the end counting most.
Vec2 straight_direction(const Points& points, bool at_start, double reach) {
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();  // weighted: of ones, distances, places
  Vec2 moments = Vec2::Zero();                     // of places by distance
  double distance = 0;
  for (std::size_t i = 0; i < points.size() && distance <= reach; ++i) {
    const Vec2& point = points[at_start ? i : points.size() - 1 - i];
    if (i > 0) distance += (point - points[at_start ? i - 1 : points.size() - i]).norm();
    const double share = std::max(0.0, 1 - distance / reach);
    sums += share * share * Eigen::Vector4d(1, distance, point.x(), point.y());
    moments += share * share * distance * point;
  }
  const Vec2 inward = sums[0] * moments - sums[1] * sums.tail<2>();
  return inward.norm() > 0 ? Vec2(-inward.normalized()) : end_chord(points, at_start, reach);
}

/// The first two segments of a line that cross, far enough from its ends.
std::optional<std::pair<Index, Index>> first_crossing(const CleanLine& line, const DrawingScale& scale) {
  const double clear = line.closed ? 0 : free_reach * scale.reach(line.size) / scale.step;
  for (const auto& contact : find_contacts(SegmentGrid(segments_of(std::vector{line}), scale.step))) {
    const Index first = contact.a.position, second = contact.b.position;
    if (first >= clear && line.segment_count() - second >= clear) return std::pair(first, second);
  }
  return std::nullopt;
}

}  // namespace

double jitter_of(const std::vector<CleanLine>& lines, double step) {
  std::vector<std::pair<double, double>> all;  // unevenness and length
  double length = 0;
  for (const CleanLine& line : lines) {
    all.emplace_back(unevenness(line, step), croquis::length(line.points, line.closed));
    length += all.back().second;
  }
  std::sort(all.begin(), all.end());
  double below = 0;
  for (const auto& [uneven, part] : all) {
    below += part;
    if (below < steadiest_share * length) continue;
    const double share = std::clamp((uneven - steady) / (unsteady - steady), 0.0, 1.0);
    return share * share * (3 - 2 * share);
  }
  return 0;
}

Vec2 end_direction(const CleanLine& line, bool at_start, const DrawingScale& scale) {
  const double reach = tangent_steps * scale.step;
  const Vec2 tangent = end_tangent(line.points, at_start, reach);
  if (scale.jitter <= 0) return tangent;
  const double longest = std::min(direction_share * line.size, croquis::length(line.points, false) / 2);
  const Vec2 straight = straight_direction(line.points, at_start, std::max(reach, longest));
  const Vec2 mixed = (1 - scale.jitter) * tangent + scale.jitter * straight;
  return mixed.norm() > 0 ? Vec2(mixed.normalized()) : straight;
}

std::vector<Vec2> uncross(CleanLine& line, const DrawingScale& scale) {
  std::vector<Vec2> places;
  if (scale.reach_share <= 0) return places;
  const CleanLine drawn = line;
  while (const auto crossing = first_crossing(line, scale)) {
    const auto [i, k] = *crossing;
    places.push_back(line.points[i]);
    if (places.size() > most_crossings) {
      line = drawn;
      return {};
    }
    const auto first = static_cast<std::ptrdiff_t>(i) + 1, last = static_cast<std::ptrdiff_t>(k) + 1;
    const double loop = signed_area(std::span(line.points).subspan(i + 1, k - i)),
                 rest = signed_area(line.points) - loop;
    const auto lead_apart = [&](auto& values) {
      // What goes round the other way is a side that came over its opposite one: the other way round it doesn't cross.
      if (loop * rest < 0) {
        std::reverse(values.begin() + first, values.begin() + last);
      } else if (line.closed && std::abs(loop) > std::abs(rest)) {  // of a curl only the larger loop is seen
        values.erase(values.begin() + last, values.end());
        values.erase(values.begin(), values.begin() + first);
      } else {
        values.erase(values.begin() + first, values.begin() + last);
      }
    };
    lead_apart(line.points);
    lead_apart(line.raw);
    lead_apart(line.stroke);
  }
  return places;
}

}  // namespace croquis::silhouette
