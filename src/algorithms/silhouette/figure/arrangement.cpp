// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/arrangement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

// Samples of a known piece nearer to its bar than so many times what its line goes on behind it give way.
constexpr double bar_clearance = 1.5;

/// Which completion every end is in.
struct ChosenEnds {
  const FigureContext& context;
  const PartLines& part;
  const std::vector<ChosenCompletion>& chosen;
  std::vector<Index> choice;  ///< per position in part.ends: index into chosen

  const HiddenEnd& end(Index at) const { return context.junctions.ends[part.ends[at]]; }
  const CleanLine& line(Index at) const { return context.lines[end(at).line]; }
  const Vec2& place_behind_bar(Index at) const { return line(at).end(end(at).at_start); }
};

/// The other end of the same line.
Index other_end(Index end) { return end ^ 1U; }

ContourPath path_of_line(const CleanLine& line, Index index) {
  ContourPath path{line.points, {}, line.raw, line.strokes};
  for (Index i = 0; i < line.stroke.size(); ++i) {
    path.segments.push_back({true, true, line.stroke[i], index, no_index, 0, line.tube_place(i)});
  }
  return path;
}

/// An open line between the bars of its ends, the one that it is entered by first.
ContourPath path_between_bars(const ChosenEnds& ends, Index entered) {
  ContourPath path = path_of_line(ends.line(entered), ends.end(entered).line);
  if (!ends.end(entered).at_start) {
    std::ranges::reverse(path.points);
    std::ranges::reverse(path.segments);
    std::ranges::reverse(path.raw);
    std::ranges::reverse(path.strokes);
  }
  if (path.points.size() == 2) {  // the cuts of both ends need a segment each
    path.points.insert(path.points.begin() + 1, 0.5 * (path.points[0] + path.points[1]));
    path.raw.insert(path.raw.begin() + 1, 0.5 * (path.raw[0] + path.raw[1]));
    path.segments.insert(path.segments.begin() + 1, path.segments.front());
  }
  const auto cut = [&](std::size_t segment, Index at) -> ContourSegment& {
    path.segments[segment].cut = nearest_parameter(ends.end(at).at, path.points[segment], path.points[segment + 1]);
    return path.segments[segment];
  };
  cut(0, entered).drawn_before = false;
  cut(path.points.size() - 2, other_end(entered)).drawn_after = false;
  return path;
}

Points curve_points(const ChosenEnds& ends, const CompletionCandidate& candidate, Index shape, Index leaving) {
  Cubic curve = candidate.curve;
  if (candidate.b == leaving) std::ranges::reverse(curve);
  const HiddenEnd& end = ends.end(leaving);
  return completion_points(curve, completion_shapes[candidate.shapes[shape]], ends.context.scale.step,
                           ends.context.lines[end.bar], end.bar_side);
}

/// A known piece, between the places behind their bars that the two ends were carried on to.
Points given_points(const ChosenEnds& ends, const GivenPiece& given, Index leaving, Index arriving) {
  Points points = given.points;
  if (given.from != ends.part.ends[leaving]) std::ranges::reverse(points);
  for (const Index at : {leaving, arriving}) {
    const Vec2& bar = ends.end(at).at;
    const double least = bar_clearance * (ends.place_behind_bar(at) - bar).norm();
    std::erase_if(points, [&](const Vec2& place) { return (place - bar).norm() < least; });
  }
  points.insert(points.begin(), ends.place_behind_bar(leaving));
  points.push_back(ends.place_behind_bar(arriving));
  return points;
}

/// Appends a piece but its last point, with which the next one begins. A stroke that is hidden in between comes as
/// several lines and as what is known between them.
void append_piece(const ContourPath& piece, ContourPath& path) {
  path.points.insert(path.points.end(), piece.points.begin(), piece.points.end() - 1);
  path.segments.insert(path.segments.end(), piece.segments.begin(), piece.segments.end() - 1);
  path.raw.insert(path.raw.end(), piece.raw.begin(), piece.raw.end() - 1);
  for (const Index stroke : piece.strokes) {
    if (std::ranges::find(path.strokes, stroke) == path.strokes.end()) path.strokes.push_back(stroke);
  }
}

/// Appends the completion from an end. Returns the end it leads to.
Index append_completion(const ChosenEnds& ends, Index leaving, ContourPath& path, Arrangement& result) {
  const Index choice = ends.choice[leaving];
  const auto& [taken, shape] = ends.chosen[choice];
  const CompletionCandidate& candidate = ends.part.candidates[taken];
  const Index arriving = candidate.a == leaving ? candidate.b : candidate.a;
  ContourPath piece;
  Index stroke = ends.line(leaving).end_stroke(ends.end(leaving).at_start);
  if (candidate.given == no_index) {
    piece.points = curve_points(ends, candidate, shape, leaving);
  } else {
    const GivenPiece& given = ends.context.junctions.given[candidate.given];
    piece.points = given_points(ends, given, leaving, arriving);
    stroke = given.stroke;
    piece.strokes = {stroke};
  }
  piece.raw = piece.points;
  piece.segments.assign(piece.points.size(), {false, false, stroke, no_index, choice, 0, {}});
  append_piece(piece, path);
  EndPair joined{stroke_end(ends.context, ends.end(leaving)), stroke_end(ends.context, ends.end(arriving))};
  std::ranges::sort(joined);
  result.completions.push_back(
      {std::move(piece.points), static_cast<Index>(result.paths.size()), candidate.cost(), joined});
  return arriving;
}

/// Follows lines and completions from the start of a line until it comes again.
bool add_open_lines(const ChosenEnds& ends, Index first, std::vector<char>& done, Arrangement& result) {
  ContourPath path;
  Index entered = first;
  do {
    const HiddenEnd& end = ends.end(entered);
    if (done[end.line]) return false;  // walked in both directions: the sides contradict each other
    done[end.line] = 1;
    const int side = (end.at_start ? 1 : -1) * ends.context.junctions.sides[end.line];
    if (side != 0 && path.side == -side) return false;
    if (side != 0) path.side = side;
    append_piece(path_between_bars(ends, entered), path);
    entered = append_completion(ends, other_end(entered), path, result);
  } while (ends.end(entered).line != ends.end(first).line);
  result.paths.push_back(std::move(path));
  return entered == first;
}

/// A crossing as seen by one of its two strands.
struct Passage {
  double fraction = 0;  ///< along the segment
  Index crossing = 0;
  Index strand = 0;
};

/// Per segment of a contour: its crossings in order along it.
using Passages = std::vector<std::vector<Passage>>;

/// Adds the crossings; their strands aren't known yet. What is drawn may lie over what is drawn.
/// @return per contour
std::vector<Passages> find_crossings(const VisibleCrossings& order, double spacing, Arrangement& result) {
  std::vector<Passages> passages;
  for (const ContourPath& path : result.paths) passages.emplace_back(path.points.size());
  for (const SegmentContact& found : find_contacts(SegmentGrid(segments_of(result.paths), spacing))) {
    const auto k = static_cast<Index>(result.contour_crossings.size());
    result.points.push_back(found.at);
    ContourCrossing& crossing = result.contour_crossings.emplace_back();
    crossing.sign = found.sign;
    const ContourSegment& a = result.paths[found.a.line].segments[found.a.position];
    const ContourSegment& b = result.paths[found.b.line].segments[found.b.position];
    if (order.in_front.contains({a.line, b.line})) crossing.over = 0;
    if (order.in_front.contains({b.line, a.line})) crossing.over = 1;
    const PassingAt passing = passing_at(order.passings, a.tube, b.tube);
    crossing.passing = passing.passing;
    if (passing.passing != no_index) crossing.over = passing.over;
    passages[found.a.line][found.a.position].push_back({found.fraction_a, k, 0});
    passages[found.b.line][found.b.position].push_back({found.fraction_b, k, 1});
  }
  for (Passages& segments : passages) {
    for (std::vector<Passage>& along : segments) {
      std::ranges::sort(along, {},
                        [](const Passage& passage) { return std::pair(passage.fraction, passage.crossing); });
    }
  }
  return passages;
}

/// Which of the crossings on a stem's last segment is its bar's: the one nearest to the cut.
std::size_t bar_crossing(const ContourSegment& segment, const std::vector<Passage>& passages) {
  const auto miss = [&](const Passage& passage) { return std::abs(passage.fraction - segment.cut); };
  return static_cast<std::size_t>(std::ranges::min_element(passages, {}, miss) - passages.begin());
}

/// Adds a contour with its crossings as vertices.
void add_contour(const ContourPath& path, const Passages& on_segment, double merging, Arrangement& result) {
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
      add(static_cast<Index>(result.points.size()), i, segment.drawn_before);
      result.points.push_back(path.points[i]);
    }
    const bool is_cut = segment.drawn_before != segment.drawn_after;
    const std::size_t cut = is_cut ? bar_crossing(segment, passages) : passages.size();
    for (std::size_t k = 0; k < passages.size(); ++k) {
      const Passage& passage = passages[k];
      ContourCrossing& crossing = result.contour_crossings[passage.crossing];
      crossing.strands[passage.strand] = {index, static_cast<Index>(contour.vertices.size())};
      if (k == cut) crossing.over = 1 - passage.strand;  // at a T-junction the other contour is in front
      const Index next = (i + 1) % count;
      if (k + 1 == passages.size() && ends_in_crossing(i) && on_segment[next].empty()) {
        add(passage.crossing, next, path.segments[next].drawn_before);  // in the place of the sample there
      } else {
        add(passage.crossing, i, k < cut ? segment.drawn_before : segment.drawn_after);
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
      if (vertices[i] < result.contour_crossings.size()) starts.push_back(i);
    }
    if (starts.empty()) starts.push_back(0);
    starts.push_back(starts.front() + count);
    for (std::size_t k = 0; k + 1 < starts.size(); ++k)
      add_arc({c, starts[k], starts[k + 1] - starts[k]}, order, result);
  }
  for (ContourCrossing& crossing : result.contour_crossings) {
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
void wind(Arrangement& arrangement) {
  std::vector<std::vector<Index>> arcs_of(arrangement.area.size());
  for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
    for (const Index face : arrangement.beside_arc[arc]) arcs_of[face].push_back(arc);
  }
  arrangement.winding.assign(arrangement.area.size(), {});
  arrangement.winding[0].assign(arrangement.contours.size(), 0);
  std::vector<Index> reached{0};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const Index face = reached[k];
    for (const Index arc : arcs_of[face]) {
      const auto& [left, right] = arrangement.beside_arc[arc];
      const Index next = right == face ? left : right;
      if (!arrangement.winding[next].empty()) continue;
      arrangement.winding[next] = arrangement.winding[face];
      arrangement.winding[next][arrangement.arcs[arc].contour] += right == face ? 1 : -1;
      reached.push_back(next);
    }
  }
}

}  // namespace

StrokeEnd stroke_end(const FigureContext& context, const HiddenEnd& end) {
  const CleanLine& line = context.lines[end.line];
  const Index stroke = line.end_stroke(end.at_start);
  if (line.strokes.size() == 1) return {stroke, end.at_start};
  const std::vector<StrokeSample>& samples = context.drawing.strokes[stroke].samples;
  const auto miss = [&](const StrokeSample& sample) { return (sample.position - end.at).norm(); };
  return {stroke, miss(samples.front()) <= miss(samples.back())};
}

Arrangement close_contours(const FigureContext& context, const PartLines& part,
                           const std::vector<ChosenCompletion>& chosen) {
  ChosenEnds ends{context, part, chosen, std::vector<Index>(part.ends.size())};
  for (Index k = 0; k < chosen.size(); ++k) {
    ends.choice[part.candidates[chosen[k].candidate].a] = k;
    ends.choice[part.candidates[chosen[k].candidate].b] = k;
  }
  Arrangement result;
  std::vector<char> done(context.lines.size(), 0);
  Index start = 0;
  for (const Index line : part.lines) {
    if (context.lines[line].closed) {
      result.paths.push_back(path_of_line(context.lines[line], line));
      result.paths.back().side = context.junctions.sides[line];
      continue;
    }
    if (!done[line] && !add_open_lines(ends, start, done, result)) return {};
    start += 2;
  }
  return result;
}

Arrangement cross_contours(Arrangement closed, const VisibleCrossings& order, double spacing, double merging) {
  const std::vector<Passages> passages = find_crossings(order, spacing, closed);
  for (Index c = 0; c < closed.paths.size(); ++c) add_contour(closed.paths[c], passages[c], merging, closed);
  add_arcs(order, closed);
  return closed;
}

void find_faces(Arrangement& arrangement) {
  PlanarTriangulationResult made = triangulate(arrangement.points, arrangement.segments);
  arrangement.conflicts = conflict_places(arrangement, made);
  if (!arrangement.conflicts.empty()) return;
  arrangement.triangulation = std::move(made.triangulation);
  arrangement.area.assign(number_faces(arrangement.triangulation, arrangement.faces), 0.0);
  arrangement.beside_arc.assign(arrangement.arcs.size(), {0, 0});
  for (Index t = 0; t < arrangement.faces.size(); ++t) {
    const Index face = arrangement.faces[t];
    const std::array<Index, 3>& corners = arrangement.triangulation.triangles[t];
    const auto& [a, b, c] = corners;
    const Points& p = arrangement.points;
    if (face != 0) arrangement.area[face] += 0.5 * cross(p[b] - p[a], p[c] - p[a]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index segment = arrangement.triangulation.constraints[t][i];
      if (segment == no_index) continue;
      const bool is_left = corners[(i + 1) % 3] == arrangement.segments[segment][0];
      arrangement.beside_arc[arrangement.segment_arc[segment]][is_left ? 0 : 1] = face;
    }
  }
  wind(arrangement);
}

}  // namespace croquis::silhouette
