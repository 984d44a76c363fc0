// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/doubled_strokes.h"

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

std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(stroke_segments(strokes), scale.step, reach);
  std::map<std::pair<Index, Index>, Company> company;
  for (Index s = 0; s < strokes.size(); ++s) {
    for (const Vec2& point : strokes[s].points) {
      for (const auto& [other, distance] : lines_beside(grid, point, s, reach)) company[{s, other}].add(distance);
    }
  }
  std::vector<Index> doubled(strokes.size(), no_index);
  for (const auto& [pair, distances] : company) {
    const auto& [s, other] = pair;
    const auto size = strokes[s].points.size(), other_size = strokes[other].points.size();
    if (size > other_size || (size == other_size && s < other)) continue;  // asked of the shorter one
    if (distances.count < doubling_share * static_cast<double>(size) || distances.is_strand(scale.unit)) continue;
    if (strokes[s].told == StrokeKind::Visible) doubled[s] = other;
  }
  return doubled;
}

}  // namespace croquis::silhouette
