// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/clean_line.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Ends that lie aside of one another are bent together over so many times the distance between them, as far as their
// strokes are long enough.
constexpr double bending_ratio = 6;
constexpr double longest_bend = 0.3;
// A line runs on beyond its start by no more than so many times what closes it.
constexpr double longest_overlap = 1.5;
// Directions at joined ends are taken over so many times the distance between the ends.
constexpr double direction_ratio = 2;
// Two directions that differ by more than 60 degrees make a corner, which isn't bent.
constexpr double corner_cosine = 0.5;
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
constexpr std::size_t most_self_crossings = 30;
// Nor is one nearer to an end than so many times what an end may miss.
constexpr double free_reach = 2;

/// Drops samples at the end that lie beyond the place where the line goes on.
void trim_overlap(CleanLine& line, const Vec2& next, double reach) {
  if (line.points.size() < 3) return;
  const Vec2 outward = end_chord(line.points, false, reach);
  auto count = static_cast<Index>(line.points.size());
  while (count > 2 && (next - line.points[count - 1]).dot(outward) < 0 &&
         (next - line.points[count - 1]).norm() < reach) {
    --count;
  }
  line.change_samples([count](auto& values) { values.resize(count); });
}

double smooth_step(double share) { return share * share * (3 - 2 * share); }

/// Brings the end of one line and the start of another (or of the same) opposite each other: samples are moved by less
/// and less from there on.
/// @param length of the shorter one
void bend_together(std::span<Vec2> ending, std::span<Vec2> starting, double length) {
  const Vec2 miss = starting.front() - ending.back();
  const double reach = std::max(direction_ratio * miss.norm(), 1e-9 * length);
  const Vec2 on = end_chord(ending, false, reach);
  const Vec2 back = end_chord(starting, true, reach);
  if (on.dot(-back) < corner_cosine) return;
  const Vec2 along = (on - back).normalized();
  const Vec2 aside = miss - miss.dot(along) * along;
  const double bent = std::min(bending_ratio * aside.norm(), longest_bend * length);
  if (!(bent > 0)) return;
  for (const bool at_start : {false, true}) {
    const Vec2 by = (at_start ? -0.5 : 0.5) * aside;
    walk_back(at_start ? starting : ending, at_start, bent, [&](Vec2& point, double distance) {
      point += smooth_step(std::clamp(1 - distance / bent, 0.0, 1.0)) * by;
    });
  }
}

/// Closes a line whose last bit crosses its first bit there, at the crossing nearest to the start.
bool close_at_crossing(CleanLine& line, double reach, double spacing) {
  const Points& points = line.points;
  const auto last = static_cast<Index>(points.size() - 1);
  const Index most = std::min(static_cast<Index>(reach / spacing) + 1, last / 3);
  for (Index i = 0; i < most; ++i) {
    for (Index k = last - most; k < last; ++k) {
      if (!segments_cross(points[i], points[i + 1], points[k], points[k + 1])) continue;
      const double fraction = crossing_fraction(points[i], points[i + 1], points[k], points[k + 1]);
      const Vec2 at = points[i] + fraction * (points[i + 1] - points[i]);
      line.change_samples([&](auto& values) {
        values.resize(k + 1);
        values.erase(values.begin(), values.begin() + i);
      });
      line.points.front() = at;
      return true;
    }
  }
  return false;
}

/// Makes the end of a line run into its start.
void close_line(CleanLine& line, const DrawingScale& scale) {
  const double length = croquis::length(line.points, false);
  if (scale.aside_share <= 0) return trim_overlap(line, line.points.front(), scale.gap);
  const double spacing = length / static_cast<double>(line.points.size() - 1);
  if (close_at_crossing(line, scale.close_share * length, spacing)) return;
  trim_overlap(line, line.points.front(), std::max(scale.gap, longest_overlap * scale.close_share * length));
  const std::span<Vec2> points(line.points);
  const std::size_t half = points.size() / 2;
  bend_together(points.subspan(half), points.first(half), length / 2);
}

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
Vec2 straight_direction(std::span<const Vec2> points, bool at_start, double reach) {
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();  // weighted: of ones, distances, places
  Vec2 moments = Vec2::Zero();                     // of places by distance
  walk_back(points, at_start, reach, [&](const Vec2& point, double distance) {
    const double share = std::max(0.0, 1 - distance / reach);
    sums += share * share * Eigen::Vector4d(1, distance, point.x(), point.y());
    moments += share * share * distance * point;
  });
  const Vec2 inward = sums[0] * moments - sums[1] * sums.tail<2>();
  return inward.norm() > 0 ? Vec2(-inward.normalized()) : end_chord(points, at_start, reach);
}

}  // namespace

CleanLine join_chain(const StrokeChain& chain, const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  CleanLine line;
  line.closed = chain.closed;
  for (const ChainLink& link : chain.links) {
    const SampledStroke& stroke = strokes[link.index];
    Points points = stroke.points;
    if (link.reversed) std::reverse(points.begin(), points.end());
    if (!line.points.empty()) {
      trim_overlap(line, points.front(), std::max(scale.gap, scale.reach_share * stroke.size));
      if (scale.aside_share > 0) bend_together(line.points, points, stroke.length);
    }
    line.points.insert(line.points.end(), points.begin(), points.end());
    line.stroke.insert(line.stroke.end(), points.size(), stroke.stroke);
    line.strokes.push_back(stroke.stroke);
    if (line.object.empty()) line.object = stroke.object;
  }
  const bool drawn_closed = chain.links.size() == 1 && strokes[chain.links.front().index].closed;
  if (line.closed && !drawn_closed && line.points.size() > 3) close_line(line, scale);
  return line;
}

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
    return smooth_step(std::clamp((uneven - steady) / (unsteady - steady), 0.0, 1.0));
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
  if (scale.reach_share <= 0) return {};
  const CleanLine drawn = line;
  const double clear = line.closed ? 0 : free_reach * scale.reach(line.size) / scale.step;
  std::vector<Vec2> places;
  while (places.size() <= most_self_crossings) {
    const auto contacts = find_contacts(SegmentGrid(segments_of_lines(line), scale.step));
    const auto crossing = std::ranges::find_if(contacts, [&](const SegmentContact& contact) {
      return contact.a.position >= clear && line.segment_count() - contact.b.position >= clear;
    });
    if (crossing == contacts.end()) return places;
    places.push_back(line.points[crossing->a.position]);
    const Index first = crossing->a.position + 1, last = crossing->b.position + 1;
    const double loop = signed_area(std::span(line.points).subspan(first, last - first)),
                 rest = signed_area(line.points) - loop;
    line.change_samples([&](auto& values) {
      // What goes round the other way is a side that came over its opposite one: the other way round it doesn't cross.
      if (loop * rest < 0) {
        std::reverse(values.begin() + first, values.begin() + last);
      } else if (line.closed && std::abs(loop) > std::abs(rest)) {  // of a curl only the larger loop is seen
        values.erase(values.begin() + last, values.end());
        values.erase(values.begin(), values.begin() + first);
      } else {
        values.erase(values.begin() + first, values.begin() + last);
      }
    });
  }
  line = drawn;
  return {};
}

}  // namespace croquis::silhouette
