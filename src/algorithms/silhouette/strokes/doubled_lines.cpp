// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/doubled_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) over the share of the shorter one look like one line.
constexpr double doubling_distance = 6;
constexpr double doubling_share = 0.6;

// Lines that keep to one side of one another, this far apart (u) or more, are two outlines: the sides of a thin tube.
constexpr double strand_distance = 2;
// They keep to one side when their mean distance is so many times its standard deviation.
constexpr double steadiness = 2;

/// How far another line runs from the samples of one.
struct Company {
  double count = 0;
  double sum = 0;  ///< of signed distances, left of the other line positive
  double squares = 0;

  void add(double distance) {
    ++count;
    sum += distance;
    squares += distance * distance;
  }

  bool is_strand(double unit) const {
    const double mean = std::abs(sum) / count;
    const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    return mean >= strand_distance * unit && mean >= steadiness * deviation;
  }
};

/// Signed distances to the lines other than `own` that are within `reach` of a place.
std::map<Index, double> lines_beside(const SegmentGrid& grid, const Vec2& place, Index own, double reach) {
  std::map<Index, double> beside;
  const Vec2 box = Vec2::Constant(reach);
  grid.near_box(place - box, place + box, [&](Index i) {
    const GridSegment& segment = grid.segments()[i];
    if (segment.line == own) return;
    const Vec2 along = segment.b - segment.a;
    const Vec2 away = place - (segment.a + nearest_parameter(place, segment.a, segment.b) * along);
    const double distance = away.norm();
    if (distance > reach) return;
    const auto [entry, fresh] = beside.try_emplace(segment.line, reach);
    if (fresh || distance < std::abs(entry->second)) entry->second = cross(along, away) < 0 ? -distance : distance;
  });
  return beside;
}

}  // namespace

Findings find_doubled_lines(const Drawing& drawing, const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(line_segments(lines), scale.step, reach);
  std::map<std::pair<Index, Index>, Company> company;
  for (Index line = 0; line < lines.size(); ++line) {
    for (const Vec2& point : lines[line].points) {
      for (const auto& [other, distance] : lines_beside(grid, point, line, reach)) company[{line, other}].add(distance);
    }
  }
  Findings findings;
  for (const auto& [pair, distances] : company) {
    const auto& [line, other] = pair;
    const auto size = lines[line].points.size();
    const auto other_size = lines[other].points.size();
    if (size > other_size || (size == other_size && line > other)) continue;  // asked of the shorter one
    if (distances.count < doubling_share * static_cast<double>(size) || distances.is_strand(scale.unit)) continue;
    const Index first = std::min(lines[line].strokes.front(), lines[other].strokes.front());
    const Index second = std::max(lines[line].strokes.front(), lines[other].strokes.front());
    findings.push_back(make_warning(Category::Geometry, "W_DOUBLE",
                                    in_quotes(drawing, first) + " and " + in_quotes(drawing, second) +
                                        " look like the same line: remove one of them if they are",
                                    {stroke_subject(drawing, first), stroke_subject(drawing, second)}));
  }
  return findings;
}

}  // namespace croquis::silhouette
