// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/connections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/reading/reading_costs.h"
#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Outward directions are taken over this length (u), for the last samples alone are mostly noise; and over a shorter
// one, for around a tight bend, such as the tip of a limb, the long chord points elsewhere. Neither is more than a
// share of the stroke.
constexpr double chord_reach = 40;
constexpr double bend_reach = 20;
constexpr double chord_share = 0.1;
// Below this distance (u) the direction from end to end is noise.
constexpr double negligible_gap = 3;
// A stroke that closes itself may lack so much of its length.
constexpr double farthest_closing = 0.3;
// Two strokes that make an outline together may lack so much of the length of the shorter one.
constexpr double farthest_opening = 1.0 / 3;
// Ends of two strokes may be apart by so much of what hands miss by, and always by so much of the drawing (1000 u).
constexpr double farthest_gap = 2.5;
constexpr double least_farthest_gap = 50;
// An end may miss what it passes behind by so much of what hands miss by.
constexpr double farthest_miss = 2.25;
constexpr double dearest_meeting = 5;
// Ends that go on as one another at less than this, and have nothing else within so much more, are one line.
constexpr double plain_cost = 0.15;
constexpr double plain_margin = 0.6;
// Hidden pieces are candidates up to this length, in typical distances of ends, and so many of them for an end.
constexpr double longest_hidden = 40;
constexpr double usual_spacing = 100, least_spacing = 4;  // u
constexpr double shortest_hidden = 0.1;                   // u
constexpr std::size_t most_hidden = 7;

/// Where an open stroke begins or ends that wasn't drawn over another one.
std::vector<LineEnd> ends_of(const std::vector<SampledStroke>& strokes, const std::vector<Index>& doubled,
                             double unit) {
  std::vector<LineEnd> ends;
  for (Index s = 0; s < strokes.size(); ++s) {
    const SampledStroke& stroke = strokes[s];
    if (stroke.closed || doubled[s] != no_index) continue;
    const double bend = std::min(bend_reach * unit, chord_share / 2 * stroke.length);
    const double chord = std::min(chord_reach * unit, chord_share * stroke.length);
    for (const bool at_start : {true, false}) {
      const Vec2& place = at_start ? stroke.points.front() : stroke.points.back();
      const Vec2 near = end_tangent(stroke.points, at_start, bend), far = end_chord(stroke.points, at_start, chord);
      ends.push_back({s, at_start, place, {near, far}});
    }
  }
  return ends;
}

/// Sum of 1 - cosine over the turns at a gap, for the better of both directions of the ends. Of ends that are near to
/// each other the direction from one to the other says little.
/// @param weight of that direction
double turn_between(const LineEnd& a, const LineEnd& b, double weight) {
  const Vec2 across = (b.place - a.place).normalized();
  double least = infinity;
  for (std::size_t reach = 0; reach < a.outward.size(); ++reach) {
    const double straight = 1 + a.outward[reach].dot(b.outward[reach]);
    const double from_a = across.dot(a.outward[reach]);
    const double from_b = -across.dot(b.outward[reach]);
    const double bridged = std::min(2 - from_a - from_b, 2 + from_a + from_b + costs::overshoot);
    least = std::min(least, weight * bridged + (1 - weight) * straight);
  }
  return least;
}

/// Joins cost more where their ends may pass behind something. Ends that plainly are one place of a line after that
/// have no other meaning.
void settle_joins(Connections& found) {
  std::vector<double> least(found.ends.size(), infinity);  // of what each end may pass behind
  for (const EndMeeting& meeting : found.meetings) least[meeting.end] = std::min(least[meeting.end], meeting.cost);
  std::vector<std::vector<double>> of_end(found.ends.size());  // costs of joins
  for (EndJoin& join : found.joins) {
    // An end that lies on a line does so by chance if it goes on as another one across a gap.
    for (const Index end : {join.a, join.b}) {
      join.cost += costs::line_at_gap * join.gap * std::max(0.0, 1 - least[end] / costs::chance_meeting);
    }
    for (const Index end : {join.a, join.b}) of_end[end].push_back(join.cost);
  }
  std::vector<Index> partner(found.ends.size(), no_index);  // of ends that plainly are one place
  for (const EndJoin& join : found.joins) {
    const auto is_only_one = [&](Index end) {
      return std::ranges::count_if(of_end[end], [&](double cost) { return cost <= join.cost + plain_margin; }) == 1;
    };
    if (join.cost >= plain_cost || !is_only_one(join.a) || !is_only_one(join.b)) continue;
    partner[join.a] = join.b;
    partner[join.b] = join.a;
  }
  std::erase_if(found.joins, [&](const EndJoin& join) {
    return (partner[join.a] != no_index || partner[join.b] != no_index) && partner[join.a] != join.b;
  });
  std::erase_if(found.meetings, [&](const EndMeeting& meeting) { return partner[meeting.end] != no_index; });
}

/// Adds the pairs of ends that hidden pieces may join, the cheapest few of each end.
void add_hidden(double unit, Connections& found) {
  std::vector<const EndMeeting*> likeliest;  // of each end; meetings are sorted by end
  for (const EndMeeting& meeting : found.meetings) {
    if (likeliest.empty() || likeliest.back()->end != meeting.end) likeliest.push_back(&meeting);
    if (meeting.cost < likeliest.back()->cost) likeliest.back() = &meeting;
  }
  Points places;
  std::vector<char> likely;
  for (const EndMeeting* meeting : likeliest) {
    places.push_back(meeting->at);
    likely.push_back(meeting->cost < 1 ? 1 : 0);
  }
  const double reference =
      std::max(typical_spacing(places, likely).value_or(usual_spacing * unit), least_spacing * unit);
  std::vector<std::vector<EndJoin>> of_end(found.ends.size());
  for (const EndMeeting* from : likeliest) {
    for (const EndMeeting* to : likeliest) {
      const double distance = (to->at - from->at).norm();
      if (to->end <= from->end || distance > longest_hidden * reference || distance < shortest_hidden * unit) continue;
      const LineEnd& a = found.ends[from->end];
      const LineEnd& b = found.ends[to->end];
      double cost = completion_cost(completion_curve(from->at, a.outward[0], to->at, b.outward[0]), 0, reference, {});
      if (a.stroke == b.stroke) cost = std::min(cost, costs::hidden_of_one_stroke);
      for (const Index end : {from->end, to->end}) {
        of_end[end].push_back({from->end, to->end, costs::flattened(costs::hidden * cost)});
      }
    }
  }
  std::map<std::pair<Index, Index>, double> kept;
  for (std::vector<EndJoin>& pairs : of_end) {
    std::ranges::sort(pairs, {}, [](const EndJoin& pair) { return std::tuple(pair.cost, pair.a, pair.b); });
    const auto cheapest = std::span(pairs).first(std::min(pairs.size(), most_hidden));
    for (const EndJoin& pair : cheapest) kept[{pair.a, pair.b}] = pair.cost;
  }
  for (const auto& [ends, cost] : kept) found.hidden.push_back({ends.first, ends.second, cost});
}

/// The strokes, and the segments of those that weren't drawn over others.
struct DrawnStrokes {
  const std::vector<SampledStroke>& strokes;
  const DrawingScale& scale;
  SegmentGrid grid;

  double reach(Index one, Index other) const { return scale.reach(std::max(strokes[one].size, strokes[other].size)); }

  /// Whether a line of other strokes lies between two places.
  bool is_blocked(const Vec2& from, const Vec2& to, Index one, Index other) const {
    bool blocked = false;
    grid.near_box(from.cwiseMin(to), from.cwiseMax(to), [&](Index i) {
      const GridSegment& segment = grid.segments()[i];
      if (segment.line == one || segment.line == other) return;
      blocked = blocked || segments_cross(from, to, segment.a, segment.b);
    });
    return blocked;
  }
};

/// Joins two ends unless they are too far apart or in two objects.
void add_join(const DrawnStrokes& drawn, Index first_end, Index second_end, Connections& found) {
  const DrawingScale& scale = drawn.scale;
  const LineEnd& a = found.ends[first_end];
  const LineEnd& b = found.ends[second_end];
  const SampledStroke& first = drawn.strokes[a.stroke];
  const SampledStroke& second = drawn.strokes[b.stroke];
  if (!first.object.empty() && !second.object.empty() && first.object != second.object) return;
  const double distance = (b.place - a.place).norm();
  const bool closing = a.stroke == b.stroke;
  const double usual = closing ? std::max(scale.gap, scale.close_share * first.length)
                               : std::max(scale.gap, scale.reach_share * (first.size + second.size) / 2);
  const double widest = closing ? std::max(scale.close, farthest_closing * first.length)
                                : std::max({farthest_gap * usual, least_farthest_gap * scale.unit,
                                            farthest_opening * std::min(first.length, second.length)});
  if (distance > widest) return;
  const double share = distance / usual;
  const double weight = distance > negligible_gap * scale.unit ? std::min(1.0, share) : 0;
  double cost = costs::gap * (closing || share > farthest_gap ? costs::opening(share) : costs::miss(share));
  cost += costs::turn * turn_between(a, b, weight);
  if (drawn.is_blocked(a.place, b.place, a.stroke, b.stroke)) cost += costs::line_between;
  found.joins.push_back({first_end, second_end, cost, std::min(1.0, share)});
}

/// What it costs that an end passes behind a line at that place.
double place_cost(const DrawnStrokes& drawn, const LineEnd& end, const EndMeeting& meeting) {
  const SampledStroke& bar = drawn.strokes[meeting.bar];
  double cost = costs::junction + (meeting.bar == end.stroke ? costs::own_line : 0);
  if (!bar.closed) {
    const double to_end = std::min((meeting.at - bar.points.front()).norm(), (meeting.at - bar.points.back()).norm());
    cost += costs::end_of_bar * std::max(0.0, 1 - to_end / drawn.reach(end.stroke, meeting.bar));
  }
  const bool blocked = meeting.along > 0 && drawn.is_blocked(end.place, meeting.at, end.stroke, meeting.bar);
  return blocked ? cost + costs::line_before_bar : cost;
}

/// Adds what an end may pass behind: on each side of each line the cheapest place.
/// @param farthest that any end is from what it passes behind
void add_meetings(const DrawnStrokes& drawn, Index which, double farthest, Connections& found) {
  const LineEnd& end = found.ends[which];
  Points back = drawn.strokes[end.stroke].points;
  if (!end.at_start) std::ranges::reverse(back);
  const double own_bit = 3 * drawn.reach(end.stroke, end.stroke);
  std::map<std::pair<Index, int>, std::vector<EndMeeting>> candidates;  // by bar and side
  const Vec2 around = Vec2::Constant(farthest);
  drawn.grid.near_box(end.place - around, end.place + around, [&](Index i) {
    const GridSegment& segment = drawn.grid.segments()[i];
    // A line passes behind its own other parts, not behind its end.
    const auto last = static_cast<Index>(back.size() - 2);
    const Index from_end = end.at_start ? segment.position : last - segment.position;
    if (segment.line == end.stroke && drawn.scale.step / 2 * from_end <= own_bit) return;
    const double usual = drawn.reach(end.stroke, segment.line);
    // The stem comes from where the bar's surface isn't; an unsteady hand's last samples say little about that.
    const Vec2 direction = (segment.b - segment.a).normalized();
    const double heading_left = (cross(direction, end.outward[0]) + cross(direction, end.outward[1])) / 2;
    for (const EndHit& hit : end_hits(back, end.outward, farthest_miss * usual, segment.a, segment.b)) {
      const bool beside = hit.way == EndHit::Way::Beside;
      if (beside && hit.along >= usual) continue;
      const double miss = costs::junction_miss * costs::miss(std::abs(hit.along) / usual);
      for (const int side : {-1, 1}) {
        const double against = costs::against_heading * std::max(0.0, -side * heading_left);
        const double cost = miss + (beside ? costs::beside : 0) + against;
        candidates[{segment.line, side}].push_back({which, segment.line, hit.at, side, hit.along, cost});
      }
    }
  });
  for (auto& [bar_and_side, meetings] : candidates) {
    const bool crossed = std::ranges::any_of(meetings, [](const EndMeeting& meeting) { return meeting.along < 0; });
    for (EndMeeting& meeting : meetings) meeting.cost += crossed && meeting.along > 0 ? costs::bar_crossed : 0;
    EndMeeting best = *std::ranges::min_element(meetings, {}, &EndMeeting::cost);
    if (best.cost >= dearest_meeting) continue;
    best.cost += place_cost(drawn, end, best);
    found.meetings.push_back(best);
  }
}

}  // namespace

Connections find_connections(const std::vector<SampledStroke>& strokes, const DrawingScale& scale,
                             const Progress& progress) {
  Connections found;
  found.doubled = doubled_strokes(strokes, scale);
  found.ends = ends_of(strokes, found.doubled, scale.unit);
  std::vector<GridSegment> segments = segments_of(strokes);
  std::erase_if(segments, [&](const GridSegment& segment) { return found.doubled[segment.line] != no_index; });
  const DrawnStrokes drawn{strokes, scale, SegmentGrid(std::move(segments), scale.step)};
  for (const SegmentContact& contact : find_contacts(drawn.grid)) ++found.crossings[{contact.a.line, contact.b.line}];
  progress.check();
  for (Index a = 0; a < found.ends.size(); ++a) {
    for (Index b = a + 1; b < found.ends.size(); ++b) add_join(drawn, a, b, found);
  }
  progress.check();
  double largest = 0;
  for (const SampledStroke& stroke : strokes) largest = std::max(largest, stroke.size);
  const double farthest = farthest_miss * scale.reach(largest);
  for (Index end = 0; end < found.ends.size(); ++end) add_meetings(drawn, end, farthest, found);
  settle_joins(found);
  progress.check();
  add_hidden(scale.unit, found);
  return found;
}

}  // namespace croquis::silhouette
