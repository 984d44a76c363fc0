// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/crossed_rings.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/strokes/covered_runs.h"
#include "algorithms/silhouette/strokes/ring_shape.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

using LinePairs = std::set<std::pair<Index, Index>>;

bool cross_each_other(const LinePairs& crossing, Index a, Index b) { return crossing.contains(std::minmax(a, b)); }

/// The smallest closed line around another one that doesn't cross it.
Index line_around(const std::vector<CleanLine>& lines, const LinePairs& crossing, Index line) {
  Index around = no_index;
  double least = 0;
  for (Index other = 0; other < lines.size(); ++other) {
    if (other == line || !lines[other].closed || cross_each_other(crossing, line, other)) continue;
    const double area = std::abs(signed_area(lines[other].points));
    if (area <= std::abs(signed_area(lines[line].points)) || (around != no_index && area >= least)) continue;
    if (!encloses(lines[other], lines[line].points.front())) continue;
    around = other;
    least = area;
  }
  return around;
}

/// Lines that cross the outline of a ring.
std::size_t things_over(const LinePairs& crossing, Index ring) {
  return static_cast<std::size_t>(std::count_if(crossing.begin(), crossing.end(), [ring](const auto& pair) {
    return pair.first == ring || pair.second == ring;
  }));
}

bool bounds_hole_of(const Drawing& drawing, const std::vector<CleanLine>& lines, const LinePairs& crossing, Index hole,
                    Index around) {
  if (const std::optional<bool> told = told_hole(drawing, lines[hole].strokes)) return *told;
  return is_hole_of_ring(lines[hole].points, lines[around].points, things_over(crossing, around));
}

}  // namespace

std::vector<Index> holes_of_rings(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                  const LinePairs& crossing) {
  std::vector<Index> ring(lines.size(), no_index);
  for (const auto& pair : crossing) {
    for (const Index line : {pair.first, pair.second}) {
      if (!lines[line].closed || ring[line] != no_index) continue;
      const Index around = line_around(lines, crossing, line);
      if (around != no_index && bounds_hole_of(drawing, lines, crossing, line, around)) ring[line] = around;
    }
  }
  return ring;
}

}  // namespace croquis::silhouette
