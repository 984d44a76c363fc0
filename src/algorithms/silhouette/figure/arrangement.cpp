// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/arrangement.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "croquis/geometry/segment_grid.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// A crossing as seen by one of its two segments.
struct Passage {
  Index contour = 0;
  Index segment = 0;
  double fraction = 0;
  Index crossing = 0;
  bool is_a = false;
};

struct RawCrossings {
  std::vector<Vec2> places;
  std::vector<int> signs;
  std::vector<Passage> passages;  ///< two per crossing
};

RawCrossings find_crossings(const std::vector<ContourPath>& contours, double spacing) {
  RawCrossings raw;
  for (const SegmentContact& found : find_contacts(SegmentGrid(segments_of(contours), spacing))) {
    const auto crossing = static_cast<Index>(raw.places.size());
    raw.places.push_back(found.at);
    raw.signs.push_back(found.sign);
    raw.passages.push_back({found.a.line, found.a.position, found.fraction_a, crossing, true});
    raw.passages.push_back({found.b.line, found.b.position, found.fraction_b, crossing, false});
  }
  std::sort(raw.passages.begin(), raw.passages.end(), [](const Passage& x, const Passage& y) {
    return std::tuple(x.contour, x.segment, x.fraction, x.crossing) <
           std::tuple(y.contour, y.segment, y.fraction, y.crossing);
  });
  return raw;
}

/// What is drawn over what is drawn.
void order_drawn_lines(const std::vector<ContourPath>& paths, const RawCrossings& raw, const VisibleCrossings& order,
                       std::vector<ContourCrossing>& crossings) {
  std::vector<std::array<Index, 2>> lines(crossings.size());
  for (const Passage& passage : raw.passages) {
    lines[passage.crossing][passage.is_a ? 0 : 1] = paths[passage.contour].segments[passage.segment].line;
  }
  for (Index k = 0; k < crossings.size(); ++k) {
    const auto [a, b] = lines[k];
    if (order.in_front.contains({a, b})) crossings[k].over = 0;
    if (order.in_front.contains({b, a})) crossings[k].over = 1;
  }
}

/// Which of the crossings on a stem's last segment is its bar's: the one nearest to the cut.
std::size_t bar_crossing(const ContourSegment& segment, const std::vector<Passage>& passages) {
  const auto miss = [&](const Passage& passage) { return std::abs(passage.fraction - segment.cut); };
  return static_cast<std::size_t>(std::ranges::min_element(passages, {}, miss) - passages.begin());
}

/// Adds a contour with its crossings as vertices.
/// @param on_segment per segment: its crossings in order along it
void add_contour(const ContourPath& path, const std::vector<std::vector<Passage>>& on_segment, double merging,
                 Arrangement& result) {
  using Drawn = ContourSegment::Drawn;
  const auto index = static_cast<Index>(result.contours.size());
  const auto count = static_cast<Index>(path.points.size());
  FigureContour& contour = result.contours.emplace_back();
  contour.strokes = path.strokes;
  contour.side = path.side;
  const auto add = [&](Index vertex, Index segment, bool drawn) {
    contour.vertices.push_back(vertex);
    contour.drawn.push_back(drawn ? 1 : 0);
    result.origins.push_back(path.segments[segment]);
  };
  const auto ends_in_crossing = [&](Index segment) {
    return !on_segment[segment].empty() && on_segment[segment].back().fraction > 1 - merging;
  };
  for (Index i = 0; i < count; ++i) {
    const ContourSegment& segment = path.segments[i];
    const std::vector<Passage>& passages = on_segment[i];
    const bool starts_in_crossing = !passages.empty() && passages.front().fraction < merging;
    if (!starts_in_crossing && !ends_in_crossing((i + count - 1) % count)) {
      add(static_cast<Index>(result.points.size()), i, segment.starts_drawn());
      result.points.push_back(path.points[i]);
    }
    const bool is_cut = segment.drawn == Drawn::UntilCut || segment.drawn == Drawn::FromCut;
    const std::size_t cut = is_cut ? bar_crossing(segment, passages) : passages.size();
    for (std::size_t k = 0; k < passages.size(); ++k) {
      const Passage& passage = passages[k];
      ContourCrossing& crossing = result.crossings[passage.crossing];
      crossing.strands[passage.is_a ? 0 : 1] = {index, static_cast<Index>(contour.vertices.size())};
      if (k == cut) crossing.over = passage.is_a ? 1 : 0;  // at a T-junction the other contour is in front
      const Index next = (i + 1) % count;
      if (k + 1 == passages.size() && ends_in_crossing(i) && on_segment[next].empty()) {
        add(passage.crossing, next, path.segments[next].starts_drawn());  // in the place of the sample there
      } else {
        add(passage.crossing, i, segment.drawn == Drawn::FromCut ? k >= cut : segment.starts_drawn() && k < cut);
      }
    }
  }
}

void add_arc(const FigureArc& piece, const VisibleCrossings& order, Arrangement& result) {
  double all = 0, drawn = 0, behind = 0;
  for (Index k = 0; k < piece.count; ++k) {
    const Index s = result.segment_of(piece, k);
    const auto& [from, to] = result.segments[s];
    const double size = (result.points[to] - result.points[from]).norm();
    all += size;
    if (result.contours[piece.contour].drawn[s - result.first_segment[piece.contour]]) {
      drawn += size;
      if (order.behind.contains(result.origins[s].line)) behind += size;
    }
    result.segment_arc[s] = static_cast<Index>(result.arcs.size());
  }
  result.arcs.push_back(piece);
  result.arcs.back().visible = 2 * drawn > all;
  result.may_be_covered.push_back(2 * drawn > all && 2 * behind > drawn ? 1 : 0);
}

/// Cuts the contours into arcs at their crossings.
void add_arcs(const VisibleCrossings& order, Arrangement& result) {
  result.segment_arc.resize(result.origins.size());
  for (Index c = 0; c < result.contours.size(); ++c) {
    const std::vector<Index>& vertices = result.contours[c].vertices;
    const auto count = static_cast<Index>(vertices.size());
    result.first_segment.push_back(static_cast<Index>(result.segments.size()));
    std::vector<Index> starts;
    for (Index i = 0; i < count; ++i) {
      result.segments.push_back({vertices[i], vertices[(i + 1) % count]});
      if (vertices[i] < result.crossings.size()) starts.push_back(i);
    }
    if (starts.empty()) starts.push_back(0);
    starts.push_back(starts.front() + count);
    for (std::size_t k = 0; k + 1 < starts.size(); ++k)
      add_arc({c, starts[k], starts[k + 1] - starts[k]}, order, result);
  }
  for (ContourCrossing& crossing : result.crossings) {
    for (auto& [contour, position, before, after] : crossing.strands) {
      const auto count = static_cast<Index>(result.contours[contour].vertices.size());
      before = result.segment_arc[result.first_segment[contour] + (position + count - 1) % count];
      after = result.segment_arc[result.first_segment[contour] + position];
    }
  }
}

std::vector<Vec2> conflict_places(const Arrangement& arrangement, const PlanarTriangulationResult& made) {
  std::vector<Vec2> places;
  for (const auto& [a, b] : made.conflict.coincident_points) places.push_back(arrangement.points[a]);
  for (const Index c : made.conflict.blocked_constraints) {
    const auto& [a, b] = arrangement.segments[c];
    places.emplace_back(0.5 * (arrangement.points[a] + arrangement.points[b]));
  }
  const bool all_on_a_line = places.empty() && made.triangulation.triangles.empty();
  if (all_on_a_line) places.push_back(arrangement.points.front());
  return places;
}

/// Numbers the faces; those that reach the hull through an edge that is no segment are face 0.
/// @return how many there are
Index number_faces(const PlanarTriangulation& plane, std::vector<Index>& of_triangle) {
  DisjointSets joined(plane.triangles.size() + 1);  // the first one is the outside
  for (Index t = 0; t < plane.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (plane.constraints[t][i] != no_index) continue;
      joined.unite(t + 1, plane.neighbours[t][i] == no_index ? 0 : plane.neighbours[t][i] + 1);
    }
  }
  const Index count = joined.number(of_triangle);
  of_triangle.erase(of_triangle.begin());
  return count;
}

/// Winding numbers spread from outside: stepping over a contour from its right to its left adds one turn.
void wind(const Arrangement& arrangement, Faces& faces) {
  std::vector<std::vector<Index>> arcs_of(faces.area.size());
  for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
    for (const Index face : faces.beside_arc[arc]) arcs_of[face].push_back(arc);
  }
  faces.winding.assign(faces.area.size(), {});
  faces.winding[0].assign(arrangement.contours.size(), 0);
  std::vector<Index> reached{0};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const Index face = reached[k];
    for (const Index arc : arcs_of[face]) {
      const auto& [left, right] = faces.beside_arc[arc];
      const Index next = right == face ? left : right;
      if (!faces.winding[next].empty()) continue;
      faces.winding[next] = faces.winding[face];
      faces.winding[next][arrangement.arcs[arc].contour] += right == face ? 1 : -1;
      reached.push_back(next);
    }
  }
}

}  // namespace

Arrangement cross_contours(const std::vector<ContourPath>& contours, const VisibleCrossings& order, double spacing,
                           double merging) {
  const RawCrossings raw = find_crossings(contours, spacing);
  Arrangement result;
  result.points = raw.places;
  result.crossings.resize(raw.places.size());
  for (Index k = 0; k < raw.signs.size(); ++k) result.crossings[k].sign = raw.signs[k];
  order_drawn_lines(contours, raw, order, result.crossings);
  auto passage = raw.passages.begin();
  for (Index c = 0; c < contours.size(); ++c) {
    std::vector<std::vector<Passage>> on_segment(contours[c].points.size());
    for (; passage != raw.passages.end() && passage->contour == c; ++passage) {
      on_segment[passage->segment].push_back(*passage);
    }
    add_contour(contours[c], on_segment, merging, result);
  }
  add_arcs(order, result);
  return result;
}

Faces find_faces(const Arrangement& arrangement) {
  Faces faces;
  PlanarTriangulationResult made = triangulate(arrangement.points, arrangement.segments);
  faces.conflicts = conflict_places(arrangement, made);
  if (!faces.conflicts.empty()) return faces;
  faces.triangulation = std::move(made.triangulation);
  faces.area.assign(number_faces(faces.triangulation, faces.of_triangle), 0.0);
  faces.beside_arc.assign(arrangement.arcs.size(), {0, 0});
  for (Index t = 0; t < faces.of_triangle.size(); ++t) {
    const Index face = faces.of_triangle[t];
    const std::array<Index, 3>& corners = faces.triangulation.triangles[t];
    const auto& [a, b, c] = corners;
    const Points& p = arrangement.points;
    if (face != 0) faces.area[face] += 0.5 * cross(p[b] - p[a], p[c] - p[a]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index segment = faces.triangulation.constraints[t][i];
      if (segment == no_index) continue;
      const bool is_left = corners[(i + 1) % 3] == arrangement.segments[segment][0];
      faces.beside_arc[arrangement.segment_arc[segment]][is_left ? 0 : 1] = face;
    }
  }
  wind(arrangement, faces);
  return faces;
}

}  // namespace croquis::silhouette
