// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/stroke_chains.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// The samples of a line while strokes are added to it.
struct Growing {
  Points points;
  std::vector<Index> stroke;

  void drop_last() {
    points.pop_back();
    stroke.pop_back();
  }
};

/// Drops samples at the end that lie beyond the place where the line goes on.
void trim_overlap(Growing& line, const Vec2& next, double reach) {
  if (line.points.size() < 3) return;
  const Vec2 outward = end_chord(line.points, false, reach);
  while (line.points.size() > 2 && (next - line.points.back()).dot(outward) < 0 &&
         (next - line.points.back()).norm() < reach) {
    line.drop_last();
  }
}

/// Moves samples from one end on by less and less.
void bend(Points& points, bool at_start, const Vec2& by, double reach) {
  const std::size_t count = points.size();
  const Vec2 end = at_start ? points.front() : points.back();
  double distance = 0;
  Vec2 before = end;
  for (std::size_t i = 0; i < count && distance < reach; ++i) {
    Vec2& point = points[at_start ? i : count - 1 - i];
    distance += (point - before).norm();
    before = point;
    const double share = std::clamp(1 - distance / reach, 0.0, 1.0);
    point += share * share * (3 - 2 * share) * by;
  }
}

/// Brings the end of one line and the start of another (or of the same) opposite each other.
/// @param length of the shorter one
void bend_together(Points& ending, Points& starting, double length) {
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

struct OwnCrossing {
  std::size_t head = 0;  ///< segments
  std::size_t tail = 0;
  Vec2 at = Vec2::Zero();
};

/// Where the last bit of a line crosses its first bit, the crossing nearest to the start.
std::optional<OwnCrossing> own_crossing(const Points& points, double reach, double spacing) {
  const auto count = static_cast<std::size_t>(reach / spacing) + 1;
  const std::size_t last = points.size() - 1;
  const std::size_t most = std::min(count, last / 3);
  for (std::size_t i = 0; i < most; ++i) {
    for (std::size_t k = last - most; k < last; ++k) {
      if (!cross_properly(points[i], points[i + 1], points[k], points[k + 1])) continue;
      const double f = crossing_fraction(points[i], points[i + 1], points[k], points[k + 1]);
      return OwnCrossing{i, k, points[i] + f * (points[i + 1] - points[i])};
    }
  }
  return std::nullopt;
}

/// Closes a line whose ends run across one another where they cross.
bool close_at_crossing(Growing& line, double reach, double spacing) {
  const std::optional<OwnCrossing> crossing = own_crossing(line.points, reach, spacing);
  if (!crossing) return false;
  const auto first = static_cast<std::ptrdiff_t>(crossing->head);
  const auto end = static_cast<std::ptrdiff_t>(crossing->tail) + 1;
  line.points = Points(line.points.begin() + first, line.points.begin() + end);
  line.stroke = std::vector<Index>(line.stroke.begin() + first, line.stroke.begin() + end);
  line.points.front() = crossing->at;
  return true;
}

/// Makes the end of a line run into its start.
void close_line(Growing& line, const DrawingScale& scale) {
  const double length = croquis::length(line.points, false);
  const bool by_size = scale.aside_share > 0;
  if (by_size) {
    const double spacing = length / static_cast<double>(line.points.size() - 1);
    if (close_at_crossing(line, scale.close_share * length, spacing)) return;
  }
  const double reach = std::max(scale.gap, longest_overlap * scale.close_share * length);
  trim_overlap(line, line.points.front(), by_size ? reach : scale.gap);
  if (!by_size) return;
  const std::size_t half = line.points.size() / 2;
  Points head(line.points.begin(), line.points.begin() + static_cast<std::ptrdiff_t>(half));
  Points tail(line.points.begin() + static_cast<std::ptrdiff_t>(half), line.points.end());
  bend_together(tail, head, length / 2);
  std::copy(head.begin(), head.end(), line.points.begin());
  std::copy(tail.begin(), tail.end(), line.points.begin() + static_cast<std::ptrdiff_t>(half));
}

}  // namespace

std::vector<GridSegment> stroke_segments(const std::vector<SampledStroke>& strokes) {
  std::vector<GridSegment> all;
  for (Index s = 0; s < strokes.size(); ++s) {
    const Points& points = strokes[s].points;
    const std::size_t count = strokes[s].closed ? points.size() : points.size() - 1;
    for (Index i = 0; i < count; ++i) all.push_back({points[i], points[(i + 1) % points.size()], s, i});
  }
  return all;
}

CleanLine join_chain(const StrokeChain& chain, const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  CleanLine line;
  line.closed = chain.closed;
  Growing growing;
  for (const ChainLink& link : chain.links) {
    const SampledStroke& stroke = strokes[link.index];
    Points points = stroke.points;
    if (link.reversed) std::reverse(points.begin(), points.end());
    if (!growing.points.empty()) {
      trim_overlap(growing, points.front(), std::max(scale.gap, scale.reach_share * stroke.size));
      if (scale.aside_share > 0) bend_together(growing.points, points, stroke.length);
    }
    growing.points.insert(growing.points.end(), points.begin(), points.end());
    growing.stroke.insert(growing.stroke.end(), points.size(), stroke.stroke);
    line.strokes.push_back(stroke.stroke);
    if (line.object.empty()) line.object = stroke.object;
  }
  const bool drawn_closed = chain.links.size() == 1 && strokes[chain.links.front().index].closed;
  if (line.closed && !drawn_closed && growing.points.size() > 3) close_line(growing, scale);
  line.points = std::move(growing.points);
  line.stroke = std::move(growing.stroke);
  return line;
}

}  // namespace croquis::silhouette
