// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/doubled_lines.h"

#include <algorithm>
#include <map>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) over the share of the shorter one look like one line.
constexpr double doubling_distance = 6;
constexpr double doubling_share = 0.6;

/// The lines other than `own` with a segment within `reach` of a place, ascending.
std::vector<Index> lines_beside(const SegmentGrid& grid, const Vec2& place, Index own, double reach) {
  std::vector<Index> beside;
  const Vec2 box = Vec2::Constant(reach);
  grid.near_box(place - box, place + box, [&](Index i) {
    const GridSegment& segment = grid.segments()[i];
    if (segment.line == own || (!beside.empty() && beside.back() == segment.line)) return;
    const Vec2 nearest = segment.a + nearest_parameter(place, segment.a, segment.b) * (segment.b - segment.a);
    if ((nearest - place).norm() <= reach) beside.push_back(segment.line);
  });
  return beside;
}

}  // namespace

Findings find_doubled_lines(const Drawing& drawing, const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(line_segments(lines), scale.step, reach);
  std::map<std::pair<Index, Index>, Index> samples_beside;
  for (Index line = 0; line < lines.size(); ++line) {
    for (const Vec2& point : lines[line].points) {
      for (const Index other : lines_beside(grid, point, line, reach)) ++samples_beside[{line, other}];
    }
  }
  Findings findings;
  for (const auto& [pair, count] : samples_beside) {
    const auto& [line, other] = pair;
    const auto size = lines[line].points.size();
    const auto other_size = lines[other].points.size();
    if (size > other_size || (size == other_size && line > other)) continue;  // asked of the shorter one
    if (count < doubling_share * static_cast<double>(size)) continue;
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
