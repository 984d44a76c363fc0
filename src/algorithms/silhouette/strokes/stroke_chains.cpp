// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/stroke_chains.h"

#include <algorithm>
#include <span>

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

/// Drops samples at the end that lie beyond the place where the line goes on.
void trim_overlap(CleanLine& line, const Vec2& next, double reach) {
  if (line.points.size() < 3) return;
  const Vec2 outward = end_chord(line.points, false, reach);
  auto count = static_cast<Index>(line.points.size());
  while (count > 2 && (next - line.points[count - 1]).dot(outward) < 0 &&
         (next - line.points[count - 1]).norm() < reach) {
    --count;
  }
  line.keep(0, count);
}

/// Moves samples from one end on by less and less.
void bend(std::span<Vec2> points, bool at_start, const Vec2& by, double reach) {
  double distance = 0;
  Vec2 before = at_start ? points.front() : points.back();
  for (std::size_t i = 0; i < points.size() && distance < reach; ++i) {
    Vec2& point = points[at_start ? i : points.size() - 1 - i];
    distance += (point - before).norm();
    before = point;
    const double share = std::clamp(1 - distance / reach, 0.0, 1.0);
    point += share * share * (3 - 2 * share) * by;
  }
}

/// Brings the end of one line and the start of another (or of the same) opposite each other.
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
  bend(ending, false, 0.5 * aside, bent);
  bend(starting, true, -0.5 * aside, bent);
}

/// Makes the end of a line run into its start.
void close_line(CleanLine& line, const DrawingScale& scale) {
  const double length = croquis::length(line.points, false);
  if (scale.aside_share <= 0) return trim_overlap(line, line.points.front(), scale.gap);
  trim_overlap(line, line.points.front(), std::max(scale.gap, longest_overlap * scale.close_share * length));
  const std::span<Vec2> points(line.points);
  const std::size_t half = points.size() / 2;
  bend_together(points.subspan(half), points.first(half), length / 2);
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

}  // namespace croquis::silhouette
