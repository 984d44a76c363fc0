// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/nested_outlines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/ring_shape.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

/// Per contour those that cross it.
std::vector<std::set<Index>> crossed_contours(const Arrangement& arrangement) {
  std::vector<std::set<Index>> crossed(arrangement.contours.size());
  for (const auto& [strands, sign, over] : arrangement.crossings) {
    const auto [a, b] = std::pair(strands[0].contour, strands[1].contour);
    if (a == b) continue;
    crossed[a].insert(b);
    crossed[b].insert(a);
  }
  return crossed;
}

/// Per contour the smallest one that it lies in, no_index for none. Contours that don't cross lie in one another with
/// all of their arcs or none.
std::vector<Index> surrounding_contours(const Arrangement& arrangement, const Faces& faces,
                                        const std::vector<double>& area, const std::vector<std::set<Index>>& crossed) {
  std::vector<Index> around(area.size(), no_index);
  for (Index c = 0; c < area.size(); ++c) {
    const Index face = faces.beside_arc[arrangement.segment_arc[arrangement.first_segment[c]]].front();
    for (Index o = 0; o < area.size(); ++o) {
      if (o == c || std::abs(area[o]) <= std::abs(area[c]) || crossed[c].contains(o)) continue;
      const bool smallest = around[c] == no_index || std::abs(area[o]) < std::abs(area[around[c]]);
      if (faces.winding[face][o] != 0 && smallest) around[c] = o;
    }
  }
  return around;
}

/// Whether a contour within another is told to bound a hole; none where nothing is told.
std::optional<bool> told_nesting(const Drawing& drawing, const ContourPath& path, const ContourPath& around) {
  if (const std::optional<bool> by_kind = told_hole(drawing, path.strokes)) return by_kind;
  const std::string own = told_object(drawing, path.strokes);
  if (own.empty()) return std::nullopt;
  return own == told_object(drawing, around.strokes);
}

}  // namespace

std::string told_object(const Drawing& drawing, const std::vector<Index>& strokes) {
  for (const Index stroke : strokes) {
    if (!drawing.strokes[stroke].object.empty()) return drawing.strokes[stroke].object;
  }
  return {};
}

std::vector<NestedOutline> read_nesting(const Drawing& drawing, const std::vector<ContourPath>& paths,
                                        const Faces& faces, Arrangement& arrangement) {
  std::vector<double> area;
  area.reserve(paths.size());
  for (const ContourPath& path : paths) area.push_back(signed_area(path.points));
  const std::vector<std::set<Index>> crossed = crossed_contours(arrangement);
  const std::vector<Index> around = surrounding_contours(arrangement, faces, area, crossed);
  const auto is_open = [&](Index c) { return around[c] != no_index && paths[c].side == 0; };
  // From the outside in: what lies in a hole is no part of the surface around the hole.
  std::vector<std::pair<int, Index>> order;
  for (Index c = 0; c < paths.size(); ++c) {
    int depth = 0;
    for (Index o = around[c]; o != no_index; o = around[o]) ++depth;
    if (is_open(c)) order.emplace_back(depth, c);
  }
  std::ranges::sort(order);
  std::vector<NestedOutline> nested;
  for (const auto& [depth, c] : order) {
    const Index outer = around[c];
    const auto filled_side = [&](Index contour) { return area[contour] >= 0 ? 1 : -1; };
    if (arrangement.contours[outer].side == -filled_side(outer)) continue;  // bounds a hole
    // What covers the outline around or is covered by it, and what else lies within it.
    std::size_t things = crossed[outer].size() + (is_open(outer) ? 2 : 0);
    for (Index other = 0; other < paths.size(); ++other) {
      if (other != c && around[other] == outer && is_open(other)) ++things;
    }
    const std::optional<bool> told = told_nesting(drawing, paths[c], paths[outer]);
    const bool hole = told ? *told : is_hole_of_ring(paths[c].points, paths[outer].points, things);
    arrangement.contours[c].side = (hole ? -1 : 1) * filled_side(c);
    nested.push_back(
        {paths[c].strokes.front(), paths[outer].strokes.front(), hole, told.has_value(), paths[c].points.front()});
  }
  return nested;
}

Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure) {
  Findings findings;
  for (const auto& [stroke, around, hole, chosen, at] : figure.nested) {
    if (chosen) continue;
    const std::string names = in_quotes(drawing, stroke) + " lies within " + in_quotes(drawing, around);
    Finding note = make_warning(Category::Geometry, "W_NESTED",
                                names + (hole ? " and was read as a hole: mark it as a part if it lies in front"
                                              : " and was read as a part in front: mark it as a hole if it is one"),
                                {stroke_subject(drawing, stroke, at)});
    note.severity = Severity::Info;
    findings.push_back(std::move(note));
  }
  return findings;
}

}  // namespace croquis::silhouette
