// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/doubled_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) over the share of the shorter one look like one line.
constexpr double doubling_distance = 6;
constexpr double doubling_share = 0.6;

// An end runs along a line no farther from it than that (u), nor than hands miss by. Where it does so for less than
// some of these distances, or for more than a share of the line, it is by chance; what is left of it is longer, too.
constexpr double retracing_distance = 10;
constexpr double least_retraced = 4;
constexpr double most_retraced = 0.5;
// Lines run along one another up to 45 degrees.
constexpr double parallel_cosine = 0.7;

// Lines that keep to one side of one another, this far apart (u) or more, are two outlines: the sides of a thin tube.
constexpr double strand_distance = 2;
// They keep to one side when their mean distance is so many times its standard deviation.
constexpr double steadiness = 2;

/// Whether a line keeps to one side of another one.
/// @param distances signed, from samples of the one to the other
bool keeps_to_one_side(const std::vector<double>& distances, double unit) {
  double sum = 0, squares = 0;
  for (const double distance : distances) {
    sum += distance;
    squares += distance * distance;
  }
  const auto count = static_cast<double>(distances.size());
  const double mean = std::abs(sum) / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  return mean >= strand_distance * unit && mean >= steadiness * deviation;
}

/// The samples that are left of a stroke while ends are cut off: from `begin` to before `end`.
struct KeptRun {
  Index begin = 0;
  Index end = 0;

  std::span<const Vec2> of(const Points& points) const { return std::span(points).subspan(begin, end - begin); }
};

/// An end of a stroke that may be cut off.
struct CutEnd {
  Index stroke = 0;
  bool at_start = false;
  double reach = 0;  ///< of what it runs along
};

/// Whether the step from one sample of a stroke to the next runs along what is left of another one, or along a part of
/// its own far from there.
bool runs_along_another(const SegmentGrid& grid, const std::vector<SampledStroke>& strokes,
                        const std::vector<KeptRun>& kept, const CutEnd& cut, Index from, Index to) {
  const Points& points = strokes[cut.stroke].points;
  const Vec2 direction = (points[to] - points[from]).normalized();
  bool found = false;
  grid.near_place(points[from], cut.reach, [&](const GridSegment& segment, const Vec2&) {
    const auto [begin, end] = kept[segment.line];
    const Index last = strokes[segment.line].closed ? end : end - 1;
    if (segment.position < begin || segment.position >= last) return;
    const Index apart = std::max(segment.position, from) - std::min(segment.position, from);
    if (segment.line == cut.stroke && apart <= points.size() / 2) return;
    const Vec2 along = segment.b - segment.a;
    found = found || std::abs(along.dot(direction)) > parallel_cosine * along.norm();
  });
  return found;
}

/// Whether another line, or the other end of the same one, ends where a stroke goes on alone, and in its direction:
/// lines that only come together don't.
/// @param onward the stroke's direction at that place
bool goes_on_from_end(const std::vector<SampledStroke>& strokes, const std::vector<KeptRun>& kept, const CutEnd& cut,
                      double length, const Vec2& place, const Vec2& onward) {
  for (Index other = 0; other < strokes.size(); ++other) {
    if (strokes[other].closed || length > most_retraced * strokes[other].length) continue;
    const std::span<const Vec2> points = kept[other].of(strokes[other].points);
    for (const bool at_start : {true, false}) {
      if (other == cut.stroke && at_start == cut.at_start) continue;
      const Vec2& end = at_start ? points.front() : points.back();
      if ((end - place).norm() <= 2 * cut.reach &&
          end_chord(points, at_start, 2 * cut.reach).dot(onward) > parallel_cosine) {
        return true;
      }
    }
  }
  return false;
}

bool may_be_outline(StrokeKind told) {
  return told == StrokeKind::Visible || told == StrokeKind::Contour || told == StrokeKind::Part ||
         told == StrokeKind::Blob || told == StrokeKind::Hole;
}

}  // namespace

std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(segments_of(strokes), scale.step);
  std::map<std::pair<Index, Index>, std::vector<double>> beside;  // distances, left of the second stroke positive
  for (Index s = 0; s < strokes.size(); ++s) {
    for (const Vec2& point : strokes[s].points) {
      std::map<Index, double> nearest;
      grid.near_place(point, reach, [&](const GridSegment& segment, const Vec2& at) {
        if (segment.line == s) return;
        const double distance = (point - at).norm();
        double& least = nearest.try_emplace(segment.line, std::numeric_limits<double>::infinity()).first->second;
        if (distance < std::abs(least)) least = cross(segment.b - segment.a, point - at) < 0 ? -distance : distance;
      });
      for (const auto& [other, distance] : nearest) beside[{s, other}].push_back(distance);
    }
  }
  std::vector<Index> doubled(strokes.size(), no_index);
  for (const auto& [pair, distances] : beside) {
    const auto& [s, other] = pair;
    const auto size = strokes[s].points.size(), other_size = strokes[other].points.size();
    if (size > other_size || (size == other_size && s < other)) continue;  // asked of the shorter one
    const bool long_enough = static_cast<double>(distances.size()) >= doubling_share * static_cast<double>(size);
    if (!long_enough || keeps_to_one_side(distances, scale.unit)) continue;
    if (strokes[s].told == StrokeKind::Visible) doubled[s] = other;
  }
  return doubled;
}

void cut_retraced_ends(std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  if (scale.reach_share <= 0) return;
  const SegmentGrid grid(segments_of(strokes), scale.step);
  std::vector<KeptRun> kept;
  for (const SampledStroke& stroke : strokes) kept.push_back({0, static_cast<Index>(stroke.points.size())});
  for (auto s = static_cast<Index>(strokes.size()); s-- > 0;) {
    const SampledStroke& stroke = strokes[s];
    if (stroke.closed || !may_be_outline(stroke.told)) continue;
    const double reach = std::min(retracing_distance * scale.unit, scale.reach_share * stroke.size);
    const double spacing = stroke.length / static_cast<double>(stroke.points.size() - 1);
    for (const bool at_start : {false, true}) {
      Index& begin = kept[s].begin;
      Index& end = kept[s].end;
      const CutEnd cut{s, at_start, reach};
      const auto sample = [&](Index steps) { return at_start ? begin + steps : end - 1 - steps; };
      Index steps = 0;  // from the end, along another line
      while (begin + steps + 1 < end &&
             runs_along_another(grid, strokes, kept, cut, sample(steps), sample(steps + 1))) {
        ++steps;
      }
      const double length = spacing * steps, rest = spacing * (end - begin - steps);
      if (std::min(length, rest) < least_retraced * reach) continue;
      const Vec2& place = stroke.points[sample(steps)];
      const auto back = static_cast<Index>(std::min(length, 2 * reach) / spacing);
      const Vec2 onward = (place - stroke.points[sample(steps - back)]).normalized();
      if (goes_on_from_end(strokes, kept, cut, length, place, onward)) (at_start ? begin += steps : end -= steps);
    }
  }
  for (Index s = 0; s < strokes.size(); ++s) {
    SampledStroke& stroke = strokes[s];
    if (kept[s].end - kept[s].begin == stroke.points.size()) continue;
    const std::span<const Vec2> left = kept[s].of(stroke.points);
    stroke.points = Points(left.begin(), left.end());
    stroke.length = length(stroke.points, false);
    stroke.size = size_of(stroke.points, false);
  }
}

}  // namespace croquis::silhouette
