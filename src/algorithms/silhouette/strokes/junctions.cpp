// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// A stem that meets its bar flatter than this sine is turned to it: its completion would cross the bar again.
constexpr double least_junction_sine = 0.3;
// A stem goes on behind its bar by this much (u).
constexpr double extension = 1.5;
// No sample lies nearer to the end of a trimmed line than this share of a step.
constexpr double least_junction_spacing = 0.3;
// A line that passes behind itself doesn't do so within so many steps of its end.
constexpr double own_end = 4;
// A hidden stroke begins no farther from the end that it goes on from than this share of its own length, or the gap
// that is closed between visible strokes.
constexpr double farthest_share = 0.15;

// Lines nearer than this (u) can't be distinguished by eye or by the triangulation that follows.
constexpr double touch_distance = 0.1;
// Crossings flatter than this sine are strokes that run into one another.
constexpr double touch_sine = 0.05;
// Neighbouring segments of one line are near each other by nature.
constexpr double own_segments = 8;
// A stem is near its bar over this many segments before it ends there.
constexpr double junction_segments = 2;

/// The segments of its bar, from the first to before the second, that the end of a line may lie on: a line passes
/// behind its own other parts, not behind the bit of this length at its end.
std::array<Index, 2> segments_to_meet(const CleanLine& bar, bool is_own, bool at_start, double own_bit) {
  std::array<Index, 2> range{0, bar.segment_count()};
  if (!is_own) return range;
  const double place = parameter_along(bar.points, at_start, own_bit);
  range[at_start ? 0 : 1] = static_cast<Index>(at_start ? std::ceil(place) : std::floor(place));
  return range;
}

/// The place on its bar that is nearest to where an end was seen to meet it.
std::optional<EndHit> hit_of(const std::vector<CleanLine>& lines, Index line, bool at_start, const EndTarget& target,
                             double step) {
  Points own = lines[line].points;
  if (!at_start) std::ranges::reverse(own);
  const double far = std::max(3 * target.miss, own_end * step);
  const std::array heading{end_tangent(own, true, tangent_steps * step)};
  const CleanLine& bar = lines[target.bar];
  const auto [first, last] = segments_to_meet(bar, target.bar == line, at_start, far);
  std::optional<EndHit> best;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = first; i < last; ++i) {
    for (const EndHit& hit : end_hits(own, heading, far, bar.points[i], bar.points[(i + 1) % bar.points.size()])) {
      double distance = (hit.at - target.at).norm();
      if (hit.way == EndHit::Way::Ahead) distance += step / 2;
      if (hit.way == EndHit::Way::Beside) distance += step + hit.along;
      if (distance >= least) continue;
      least = distance;
      best = hit;
    }
  }
  return best;
}

/// Makes the first or last sample of a line the place of a hit.
void move_end(CleanLine& line, bool at_start, const EndHit& hit, double step) {
  const auto reverse = [](auto& values) { std::ranges::reverse(values); };
  if (at_start) line.change_samples(reverse);
  const Index stroke = line.stroke.back();
  auto kept = static_cast<Index>(line.points.size());
  if (hit.along < 0) kept = static_cast<Index>(std::ceil(parameter_along(line.points, false, -hit.along)));
  while (kept > 1 && (line.points[kept - 1] - hit.at).norm() < least_junction_spacing * step) --kept;
  line.change_samples([kept](auto& values) { values.resize(std::max<Index>(kept, 1)); });
  line.points.push_back(hit.at);
  line.raw.push_back(hit.at);
  line.stroke.push_back(stroke);
  if (at_start) line.change_samples(reverse);
}

Vec2 bar_direction(const std::vector<CleanLine>& lines, const HiddenEnd& end) {
  const Points& bar = lines[end.bar].points;
  const auto segment = static_cast<std::size_t>(end.bar_parameter);
  return (bar[(segment + 1) % bar.size()] - bar[segment]).normalized();
}

/// The junction of a line that ends on its bar.
HiddenEnd junction(const std::vector<CleanLine>& lines, Index line, bool at_start, const EndTarget& target,
                   const DrawingScale& scale) {
  const CleanLine& bar = lines[target.bar];
  const auto [first, last] = segments_to_meet(bar, target.bar == line, at_start, own_end * scale.step);
  const double parameter = nearest_on_line(bar.points, target.at, first, last);
  HiddenEnd end{line,       at_start, target.bar, parameter, target.at, end_direction(lines[line], at_start, scale),
                target.side};
  const Vec2 direction = bar_direction(lines, end);
  if (end.bar_side * cross(direction, end.tangent) >= least_junction_sine) return end;
  const double ahead = end.tangent.dot(direction) >= 0 ? 1 : -1;
  end.tangent = ahead * std::sqrt(1 - least_junction_sine * least_junction_sine) * direction +
                end.bar_side * least_junction_sine * left_of(direction);
  return end;
}

/// Hands the strokes of kind "hidden" to the ends that they join. Those leave along them.
void give_pieces(const Drawing& drawing, const std::vector<SampledStroke>& hidden, const std::vector<CleanLine>& lines,
                 const DrawingScale& scale, Junctions& junctions) {
  std::vector<char> taken(junctions.ends.size(), 0);
  const auto nearest_end = [&](const Vec2& place, double farthest, Index other) {
    Index found = no_index;
    for (Index e = 0; e < junctions.ends.size(); ++e) {
      const double distance = (junctions.ends[e].at - place).norm();
      if (distance > farthest || e == other || taken[e] != 0) continue;
      farthest = distance;
      found = e;
    }
    return found;
  };
  for (const SampledStroke& stroke : hidden) {
    Points points = even_points(stroke.points, false, std::min(scale.step, stroke.length / 4));
    const double farthest = std::max(scale.gap, farthest_share * stroke.length);
    const Index from = nearest_end(points.front(), farthest, no_index);
    const Index to = nearest_end(points.back(), farthest, from);
    if (stroke.closed || from == no_index || to == no_index) {
      const char* why = stroke.closed
                            ? " is closed: draw it from where a line passes behind something to where it comes out"
                            : " begins or ends where no line does that it could go on from: draw it up to one";
      const Vec2& at = end_of(points, stroke.closed || from == no_index);
      junctions.findings.push_back({make_error(Category::Geometry, "E_HIDDEN_STROKE",
                                               "The hidden stroke " + in_quotes(drawing, stroke.stroke) + why,
                                               {stroke_subject(drawing, stroke.stroke, at)}),
                                    {}});
      continue;
    }
    const Vec2 at_first = junctions.ends[from].at - points.front();
    const Vec2 at_last = junctions.ends[to].at - points.back();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(points.size() - 1);
      points[i] += (1 - share) * at_first + share * at_last;
    }
    for (const Index e : {from, to}) {
      HiddenEnd& end = junctions.ends[e];
      taken[e] = 1;
      const Vec2 ahead = point_at(points, parameter_along(points, e == from, extension * scale.unit));
      end.tangent = (ahead - end.at).normalized();
      end.bar_side = cross(bar_direction(lines, end), end.tangent) >= 0 ? 1 : -1;
    }
    junctions.given.push_back({from, to, std::move(points), stroke.stroke});
  }
}

/// Williams' rule: a stem goes under its bar, so the bar's surface lies where the stem is heading.
void decide_sides(const Drawing& drawing, const std::vector<CleanLine>& lines, Junctions& junctions) {
  for (Index bar = 0; bar < lines.size(); ++bar) {
    std::vector<HiddenEnd> stems;
    std::ranges::copy_if(junctions.ends, std::back_inserter(stems), [bar](const auto& end) { return end.bar == bar; });
    if (stems.empty()) continue;
    const int side = junctions.sides[bar] != 0 ? junctions.sides[bar] : stems.front().bar_side;
    if (std::ranges::count(stems, side, &HiddenEnd::bar_side) == std::ssize(stems)) {
      junctions.sides[bar] = side;
      continue;
    }
    const Index on_bar = lines[bar].stroke[static_cast<std::size_t>(stems.front().bar_parameter)];
    std::vector<Subject> subjects{stroke_subject(drawing, on_bar, stems.front().at)};
    std::vector<Index> all{bar};
    for (const HiddenEnd& stem : stems) {
      subjects.push_back(stroke_subject(drawing, lines[stem.line].end_stroke(stem.at_start), stem.at));
      all.push_back(stem.line);
    }
    junctions.findings.push_back({no_solid("lines pass behind " + in_quotes(drawing, on_bar) +
                                               " on both of its sides, of which only one can be its surface",
                                           std::move(subjects)),
                                  std::move(all)});
  }
}

/// How many segments lie between two places of a line, the shorter way round a closed one.
double separation(const CleanLine& line, double a, double b) {
  const double apart = std::abs(a - b);
  return line.closed ? std::min(apart, line.segment_count() - apart) : apart;
}

/// True where `stem` is the last bit of a line and `bar` the place where that line ends.
bool is_junction(const std::vector<CleanLine>& lines, const std::vector<HiddenEnd>& ends, const GridSegment& stem,
                 const GridSegment& bar) {
  return std::ranges::any_of(ends, [&](const HiddenEnd& end) {
    if (end.line != stem.line || end.bar != bar.line) return false;
    const double last = lines[stem.line].segment_count() - 1.0;
    const double from_end = end.at_start ? stem.position : last - stem.position;
    const double from_junction = separation(lines[bar.line], bar.position + 0.5, end.bar_parameter);
    return from_end < junction_segments && from_junction < junction_segments + 1;
  });
}

bool is_crossing(const SegmentContact& contact) {
  const Vec2 u = contact.a.b - contact.a.a;
  const Vec2 v = contact.b.b - contact.b.a;
  return contact.crosses() && std::abs(cross(u, v)) > touch_sine * u.norm() * v.norm();
}

LineFinding describe(const Drawing& drawing, Index s1, Index s2, const SegmentContact& contact) {
  const bool crossing = is_crossing(contact), itself = s1 == s2;
  std::string sentence = in_quotes(drawing, s1) + (itself ? "" : " and " + in_quotes(drawing, s2));
  if (crossing) {
    sentence += itself ? " crosses itself in full view: which part" : " cross in full view: which one";
    sentence += " is in front? Let the other one stop where it passes behind";
  } else {
    sentence +=
        itself ? " touches itself: draw the two parts apart" : " touch: draw them apart, or let one end at the other";
  }
  std::vector<Subject> subjects{stroke_subject(drawing, s1, contact.at)};
  if (!itself) subjects.push_back(stroke_subject(drawing, s2, contact.at));
  subjects.push_back(crossing_subject(drawing, contact.at));
  return {make_error(Category::Geometry, crossing ? "E_CROSS" : "E_TOUCH", sentence, std::move(subjects)),
          {contact.a.line, contact.b.line}};
}

/// Lines that still cross in full view (E_CROSS), run along one another or touch (E_TOUCH); one finding for each pair
/// of strokes. A stem and its bar meet rightly, and so do lines one of which is known to lie in front. O(n) for evenly
/// spread samples.
void add_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines, const VisibleCrossings& order,
                   const DrawingScale& scale, const Progress& progress, Junctions& junctions) {
  const double reach = touch_distance * scale.unit;
  std::map<std::pair<Index, Index>, SegmentContact> worst;  // by strokes; a crossing counts as worse than a touch
  for (const SegmentContact& contact : find_contacts(SegmentGrid(segments_of(lines), scale.step), reach)) {
    progress.check();
    const auto& [a, b] = std::tie(contact.a, contact.b);
    if (order.in_front.contains({a.line, b.line}) || order.in_front.contains({b.line, a.line})) continue;
    if (lines[a.line].centre_line != no_index && lines[b.line].centre_line != no_index) continue;
    const bool are_near = a.line == b.line && separation(lines[a.line], a.position, b.position) <= own_segments;
    if (are_near && !contact.crosses()) continue;
    if (is_junction(lines, junctions.ends, a, b) || is_junction(lines, junctions.ends, b, a)) continue;
    const auto strokes = std::minmax({lines[a.line].stroke[a.position], lines[b.line].stroke[b.position]});
    const auto [place, fresh] = worst.try_emplace(strokes, contact);
    if (!fresh && is_crossing(contact) && !is_crossing(place->second)) place->second = contact;
  }
  for (const auto& [strokes, contact] : worst) {
    junctions.findings.push_back(describe(drawing, strokes.first, strokes.second, contact));
  }
}

}  // namespace

void meet_bars(std::vector<CleanLine>& lines, const DrawingScale& scale) {
  // All hits are found before any line changes.
  std::vector<std::array<std::optional<EndHit>, 2>> hits(lines.size());
  for (Index line = 0; line < lines.size(); ++line) {
    for (const Index k : {0U, 1U}) {
      if (lines[line].targets[k]) hits[line][k] = hit_of(lines, line, k == 0, *lines[line].targets[k], scale.step);
    }
  }
  for (Index line = 0; line < lines.size(); ++line) {
    for (const Index k : {1U, 0U}) {
      std::optional<EndTarget>& target = lines[line].targets[k];
      if (const std::optional<EndHit>& hit = hits[line][k]) {
        move_end(lines[line], k == 0, *hit, scale.step);
        target->at = hit->at;
        target->miss = 0;
      } else {
        target.reset();
      }
    }
  }
}

Junctions find_junctions(const Drawing& drawing, std::vector<CleanLine>& lines,
                         const std::vector<SampledStroke>& hidden, const VisibleCrossings& order,
                         const DrawingScale& scale, const Progress& progress) {
  Junctions junctions;
  junctions.jitter = scale.jitter;
  junctions.sides = order.sides;
  for (Index line = 0; line < lines.size(); ++line) {
    if (lines[line].closed) continue;
    for (const bool at_start : {true, false}) {
      if (const std::optional<EndTarget>& target = lines[line].targets[at_start ? 0 : 1]) {
        junctions.ends.push_back(junction(lines, line, at_start, *target, scale));
      } else {
        const Index stroke = lines[line].end_stroke(at_start);
        junctions.findings.push_back(
            {no_solid("the end of " + in_quotes(drawing, stroke) + " touches nothing that it could pass behind",
                      {stroke_subject(drawing, stroke, lines[line].end(at_start))}),
             {line}});
      }
    }
  }
  give_pieces(drawing, hidden, lines, scale, junctions);
  decide_sides(drawing, lines, junctions);
  add_conflicts(drawing, lines, order, scale, progress, junctions);
  // Stems go on a little past their bars, so that the two cross instead of touching.
  for (const HiddenEnd& end : junctions.ends) {
    Points& points = lines[end.line].points;
    (end.at_start ? points.front() : points.back()) = end.at + extension * scale.unit * end.tangent;
  }
  return junctions;
}

}  // namespace croquis::silhouette
