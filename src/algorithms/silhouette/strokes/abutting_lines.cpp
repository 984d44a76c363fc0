// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/abutting_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/covered_runs.h"
#include "algorithms/silhouette/strokes/segment_grid.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// In parts of its size: how deep a line is led into its neighbour, and how far to either side of where it is nearest it
// is moved.
constexpr double depth_share = 0.12;
constexpr double width_share = 0.25;

/// Where a line comes nearest to another one, or deepest into it.
struct Contact {
  Index point = 0;                                            ///< of the line
  double distance = std::numeric_limits<double>::infinity();  ///< negative within the other one
  Vec2 direction = Vec2::Zero();                              ///< unit: into the other one
};

/// @param reach no farther and no deeper than that
Contact contact_between(const CleanLine& line, const CleanLine& other, double reach) {
  const SegmentGrid grid(line_segments({other}), reach);
  const double inside = signed_area(other.points) > 0 ? 1 : -1;
  Contact found;
  for (Index i = 0; i < line.points.size(); ++i) {
    const Vec2& point = line.points[i];
    Contact here{i};
    grid.near_box(point - Vec2::Constant(reach), point + Vec2::Constant(reach), [&](Index k) {
      const GridSegment& segment = grid.segments()[k];
      const Vec2 way = segment.a + nearest_parameter(point, segment.a, segment.b) * (segment.b - segment.a) - point;
      if (way.norm() >= here.distance) return;
      here = {i, way.norm(),
              way.norm() > 0 ? way.normalized() : inside * left_of((segment.b - segment.a).normalized())};
    });
    if (other.closed && encloses(other, point)) here = {i, -std::min(reach, here.distance), -here.direction};
    if (here.distance < std::min(reach, found.distance)) found = here;
  }
  return found;
}

/// Two closed lines that weren't meant to cross lie beside one another.
bool lie_beside(const CleanLine& a, const CleanLine& b, const DrawingScale& scale) {
  const CleanLine& smaller = a.size < b.size ? a : b;
  const double shallow = scale.shallow(smaller.size);
  return a.closed && b.closed && contact_between(smaller, &smaller == &a ? b : a, shallow).distance > -shallow;
}

/// Lines that end at one another, or cross, are one thing.
DisjointSets things_of(const std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale) {
  DisjointSets things(lines.size());
  for (Index line = 0; line < targets.size(); ++line) {
    for (const std::optional<EndTarget>& target : targets[line]) {
      if (target) things.unite(line, target->bar);
    }
  }
  std::set<std::pair<Index, Index>> crossing;
  const SegmentGrid grid(line_segments(lines), scale.step);
  grid.pairs([&](Index i, Index j) {
    const GridSegment& a = grid.segments()[i];
    const GridSegment& b = grid.segments()[j];
    if (a.line != b.line && cross_properly(a.a, a.b, b.a, b.b)) crossing.insert(std::minmax(a.line, b.line));
  });
  for (const auto& [a, b] : crossing) {
    if (!lie_beside(lines[a], lines[b], scale)) things.unite(a, b);
  }
  return things;
}

void lead(CleanLine& line, const Contact& contact) {
  const std::vector<double> arcs = arc_lengths(line.points, true);
  const double width = width_share * line.size;
  const Vec2 way = (contact.distance + depth_share * line.size) * contact.direction;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double along = std::abs(arcs[i] - arcs[contact.point]);
    const double away = std::min(along, arcs.back() - along) / width;
    if (away < 1) line.points[i] += (1 + std::cos(std::numbers::pi * away)) / 2 * way;
  }
  line.led = true;
}

}  // namespace

void lead_into_neighbours(std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale) {
  if (scale.reach_share <= 0) return;
  const std::vector<Index> thing = things_of(lines, targets, scale).take_roots();
  const auto is_within_any = [&](const CleanLine& line) {
    return std::ranges::any_of(lines, [&](const CleanLine& other) {
      return &other != &line && other.closed &&
             std::ranges::all_of(line.points, [&](const Vec2& point) { return encloses(other, point); });
    });
  };
  std::vector<Eigen::AlignedBox2d> boxes(lines.size());
  for (Index i = 0; i < lines.size(); ++i) {
    for (const Vec2& point : lines[i].points) boxes[i].extend(point);
  }
  for (Index a = 0; a < lines.size(); ++a) {
    CleanLine& line = lines[a];
    if (!line.closed || line.tube || std::ranges::count(thing, thing[a]) > 1 || is_within_any(line)) continue;
    Contact nearest;
    for (Index b = 0; b < lines.size(); ++b) {
      if (b == a || lines[b].tube || lines[b].size < line.size) continue;
      const double reach = scale.reach(lines[b].size);
      if (boxes[a].exteriorDistance(boxes[b]) > reach) continue;
      const Contact contact = contact_between(line, lines[b], reach);
      if (contact.distance < nearest.distance) nearest = contact;
    }
    if (std::isfinite(nearest.distance)) lead(line, nearest);
  }
}

}  // namespace croquis::silhouette
