// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/abutting_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "croquis/geometry/segment_grid.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// In parts of its size: how deep a line is led into its neighbour, and how far to either side of where it is nearest it
// is moved.
constexpr double depth_share = 0.12;
constexpr double width_share = 0.25;

/// Where a line comes nearest to another one, or deepest into it.
struct Approach {
  std::size_t point = 0;                                      ///< of the line
  double distance = std::numeric_limits<double>::infinity();  ///< negative within the other one
  Vec2 direction = Vec2::Zero();                              ///< unit: into the other one
};

/// @param reach no farther and no deeper than that
Approach approach_of(const CleanLine& line, const CleanLine& other, double reach) {
  const SegmentGrid grid(segments_of(std::vector{other}), reach);
  const double inside = signed_area(other.points) > 0 ? 1 : -1;
  Approach found;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec2& point = line.points[i];
    Approach here{i};
    if (const std::optional<SegmentGrid::Place> nearest = grid.nearest(point, reach)) {
      const GridSegment& segment = nearest->segment;
      const Vec2 way = nearest->at - point;
      here.distance = nearest->distance;
      here.direction =
          nearest->distance > 0 ? way.normalized() : inside * left_of((segment.b - segment.a).normalized());
    }
    if (other.closed && encloses(other.points, point)) here = {i, -std::min(reach, here.distance), -here.direction};
    if (here.distance < found.distance) found = here;
  }
  return found;
}

/// Two closed lines that weren't meant to cross lie beside one another.
bool lie_beside(const CleanLine& a, const CleanLine& b, const DrawingScale& scale) {
  const bool a_is_smaller = a.size < b.size;
  const CleanLine& smaller = a_is_smaller ? a : b;
  const double shallow = scale.shallow(smaller.size);
  return a.closed && b.closed && approach_of(smaller, a_is_smaller ? b : a, shallow).distance > -shallow;
}

/// Lines that end at one another, or cross, are one thing.
DisjointSets things_of(const std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale) {
  DisjointSets things(lines.size());
  for (Index line = 0; line < targets.size(); ++line) {
    for (const std::optional<EndTarget>& target : targets[line]) {
      if (target) things.unite(line, target->bar);
    }
  }
  for (const auto& [a, b] : crossing_pairs(lines, scale)) {
    if (!lie_beside(lines[a], lines[b], scale)) things.unite(a, b);
  }
  return things;
}

bool lies_within(const CleanLine& line, const CleanLine& other) {
  return other.closed && std::ranges::all_of(line.points, [&](const Vec2& point) { return encloses(other.points, point); });
}

void lead(CleanLine& line, const Approach& approach) {
  const std::vector<double> arcs = arc_lengths(line.points, true);
  const double width = width_share * line.size;
  const Vec2 way = (approach.distance + depth_share * line.size) * approach.direction;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double along = std::abs(arcs[i] - arcs[approach.point]);
    const double away = std::min(along, arcs.back() - along) / width;
    if (away < 1) line.points[i] += (1 + std::cos(std::numbers::pi * away)) / 2 * way;
  }
  line.led = true;
}

}  // namespace

void lead_into_neighbours(std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale) {
  if (scale.reach_share <= 0) return;
  const std::vector<Index> thing = things_of(lines, targets, scale).take_roots();
  std::vector<Eigen::AlignedBox2d> boxes(lines.size());
  for (Index i = 0; i < lines.size(); ++i) {
    for (const Vec2& point : lines[i].points) boxes[i].extend(point);
  }
  for (Index a = 0; a < lines.size(); ++a) {
    CleanLine& line = lines[a];
    const auto is_around = [&](const CleanLine& other) { return &other != &line && lies_within(line, other); };
    if (!line.closed || line.tube || std::ranges::count(thing, thing[a]) > 1) continue;
    if (std::ranges::any_of(lines, is_around)) continue;
    Approach nearest;
    for (Index b = 0; b < lines.size(); ++b) {
      if (b == a || lines[b].tube || lines[b].size < line.size) continue;
      const double reach = scale.reach(lines[b].size);
      if (boxes[a].exteriorDistance(boxes[b]) > reach) continue;
      const Approach approach = approach_of(line, lines[b], reach);
      if (approach.distance < nearest.distance) nearest = approach;
    }
    if (std::isfinite(nearest.distance)) lead(line, nearest);
  }
}

}  // namespace croquis::silhouette
