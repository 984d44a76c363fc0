// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/figure_segments.h"

#include <algorithm>
#include <array>

#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

/// Lower point, higher point, index of the segment.
std::vector<std::array<Index, 3>> sorted_segments(const LabelledFigure& figure) {
  std::vector<std::array<Index, 3>> rows;
  rows.reserve(figure.segments.size());
  for (Index s = 0; s < figure.segments.size(); ++s) {
    const auto [low, high] = std::minmax(figure.segments[s][0], figure.segments[s][1]);
    rows.push_back({low, high, s});
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

Index find_segment(const std::vector<std::array<Index, 3>>& rows, Index a, Index b) {
  const std::array<Index, 3> wanted{std::min(a, b), std::max(a, b), 0};
  const auto row = std::lower_bound(rows.begin(), rows.end(), wanted);
  if (row != rows.end() && (*row)[0] == wanted[0] && (*row)[1] == wanted[1]) return (*row)[2];
  throw Error(make_error(Category::Internal, "E_INTERNAL", "A contour of the labelled figure runs off its segments"));
}

}  // namespace

std::vector<DirectedSegment> directed_segments(const LabelledFigure& figure) {
  const std::vector<std::array<Index, 3>> rows = sorted_segments(figure);
  std::vector<DirectedSegment> segments(figure.segments.size());
  for (Index c = 0; c < figure.contours.size(); ++c) {
    const std::vector<Index>& vertices = figure.contours[c].vertices;
    for (Index i = 0; i < vertices.size(); ++i) {
      const Index begin = vertices[i];
      const Index end = vertices[(i + 1) % vertices.size()];
      const Index s = find_segment(rows, begin, end);
      segments[s] = {c, i, begin, end, figure.contours[c].side, figure.arcs[figure.segment_arc[s]].depth};
    }
  }
  return segments;
}

std::vector<std::vector<Index>> segments_of_contours(const LabelledFigure& figure,
                                                     const std::vector<DirectedSegment>& segments) {
  std::vector<std::vector<Index>> result;
  for (const FigureContour& contour : figure.contours) result.emplace_back(contour.vertices.size(), no_index);
  for (Index s = 0; s < segments.size(); ++s) {
    if (segments[s].contour != no_index) result[segments[s].contour][segments[s].position] = s;
  }
  return result;
}

std::array<Vec2, 2> bounds_of(const std::vector<Vec2>& points) {
  std::array<Vec2, 2> bounds{Vec2::Zero(), Vec2::Zero()};
  if (!points.empty()) bounds = {points.front(), points.front()};
  for (const Vec2& point : points) bounds = {bounds[0].cwiseMin(point), bounds[1].cwiseMax(point)};
  return bounds;
}

}  // namespace croquis::silhouette
