// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/visible_crossings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/ring_shape.h"
#include "croquis/geometry/segment_grid.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// Samples on the wrong side are moved to this share of what counts as shallow on the right one.
constexpr double moved_share = 0.5;
// Lines nearer than this (u) can't be distinguished by eye or by the triangulation that follows.
constexpr double touch_distance = 0.1;
// Crossings flatter than this sine are strokes that run into one another.
constexpr double touch_sine = 0.05;
// Neighbouring segments of one line are near each other by nature.
constexpr double own_segments = 8;
// A stem is near its bar over this many segments before it ends there.
constexpr double junction_segments = 2;

// Which of two lines lies in front.

/// The smallest closed line around another one that doesn't cross it, or no_index.
Index line_around(const std::vector<CleanLine>& lines, const LinePairs& crossing, Index line) {
  const auto area = [&](Index i) { return std::abs(signed_area(lines[i].points)); };
  Index around = no_index;
  for (Index other = 0; other < lines.size(); ++other) {
    if (!lines[other].closed || crossing.contains(std::minmax(line, other)) || area(other) <= area(line)) continue;
    if (around != no_index && area(other) >= area(around)) continue;
    if (encloses(lines[other].points, lines[line].points.front())) around = other;
  }
  return around;
}

/// The closed line that another one is a hole of, else the line itself. The stroke's own "kind" decides, else the shape
/// of the ring between the two.
Index ring_of(const Drawing& drawing, const std::vector<CleanLine>& lines, const LinePairs& crossing, Index line) {
  const Index around = lines[line].closed ? line_around(lines, crossing, line) : no_index;
  if (around == no_index) return line;
  const auto things = std::ranges::count_if(
      crossing, [around](const auto& pair) { return pair.first == around || pair.second == around; });
  const std::optional<bool> told = told_hole(drawing, lines[line].strokes);
  const bool hole =
      told ? *told : is_hole_of_ring(lines[line].points, lines[around].points, static_cast<std::size_t>(things));
  return hole ? around : line;
}

Index last_stroke(const CleanLine& line) { return std::ranges::max(line.strokes); }

bool told_behind_line(const Drawing& drawing, const CleanLine& line, const CleanLine& other) {
  return std::ranges::any_of(line.strokes, [&](Index s) {
    return std::ranges::any_of(other.strokes,
                               [&](Index t) { return told_behind(drawing.strokes[s], drawing.strokes[t]); });
  });
}

/// A line in front of another one.
struct Cover {
  Index front = 0;
  Index behind = 0;
  bool chosen = false;   ///< told by the strokes
  bool is_hole = false;  ///< of a ring, which is told of by itself
};

/// @param rings per line that crosses others, see `ring_of`
std::optional<Cover> cover_between(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                   const std::vector<Index>& rings, Index a, Index b) {
  if (!lines[a].closed && !lines[b].closed) return std::nullopt;
  if (!lines[b].closed) return Cover{a, b};
  if (!lines[a].closed) return Cover{b, a};
  const auto ring = [&](Index line) -> const CleanLine& { return lines[rings[line]]; };
  Index front = a, behind = b;
  if (last_stroke(ring(b)) >= last_stroke(ring(a))) std::swap(front, behind);
  const bool later_is_behind = told_behind_line(drawing, ring(front), ring(behind));
  const bool chosen = later_is_behind || told_behind_line(drawing, ring(behind), ring(front));
  if (later_is_behind) std::swap(front, behind);
  return Cover{front, behind, chosen, rings[front] != front};
}

std::vector<Cover> covers_of(const Drawing& drawing, const std::vector<CleanLine>& lines, const LinePairs& crossing,
                             bool tubes_only) {
  std::vector<Index> rings(lines.size(), no_index);
  std::vector<Cover> covers;
  for (const auto& [a, b] : crossing) {
    if (tubes_only && !lines[a].grows() && !lines[b].grows()) continue;
    for (const Index line : {a, b}) {
      if (rings[line] == no_index) rings[line] = ring_of(drawing, lines, crossing, line);
    }
    if (const std::optional<Cover> cover = cover_between(drawing, lines, rings, a, b)) covers.push_back(*cover);
  }
  // Lines are moved where they nearly touch, those in front first; what crosses then was meant to.
  std::ranges::stable_sort(covers, std::greater(), [&](const Cover& c) { return last_stroke(lines[c.behind]); });
  return covers;
}

// The runs of a line that lie behind another one.

/// A stretch of a line between crossings, by parameters; of a closed one `end` may run on past the first point.
struct LineRun {
  double begin = 0;
  double end = 0;
  bool inside = false;  ///< of the cover, as drawn
  bool meant = false;   ///< to be inside
  double depth = 0;     ///< how far it gets away from the cover, counted up to twice of what is shallow
};

/// Ascending parameters of the places where a line crosses another one.
std::vector<double> crossing_parameters(const CleanLine& line, const CleanLine& other, double step) {
  std::vector<double> parameters;
  for (const SegmentContact& contact : find_contacts(SegmentGrid(segments_of(std::vector{line, other}), step))) {
    if (contact.a.line != contact.b.line) parameters.push_back(contact.a.position + contact.fraction_a);
  }
  std::ranges::sort(parameters);
  return parameters;
}

/// The runs between crossings. Sides alternate; the longest run tells which it is.
std::vector<LineRun> runs_between(const std::vector<double>& crossings, const CleanLine& line, const CleanLine& cover) {
  const double last = line.segment_count();
  std::vector<LineRun> runs;
  if (!line.closed) runs.push_back({0, crossings.front()});
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k) runs.push_back({crossings[k], crossings[k + 1]});
  runs.push_back({crossings.back(), line.closed ? crossings.front() + last : last});
  const auto longest = std::ranges::max_element(runs, {}, [](const LineRun& run) { return run.end - run.begin; });
  const double middle = 0.5 * (longest->begin + longest->end);
  const bool inside = encloses(cover.points, point_at(line.points, middle));
  for (auto run = runs.begin(); run != runs.end(); ++run) {
    run->inside = run->meant = inside == ((run - longest) % 2 == 0);
  }
  return runs;
}

/// Runs that are too shallow are meant to lie where the next one towards the deepest one does.
void join_shallow_runs(std::vector<LineRun>& runs, bool closed, double shallow) {
  const auto count = static_cast<std::ptrdiff_t>(runs.size());
  const auto deepest = std::ranges::max_element(runs, {}, &LineRun::depth) - runs.begin();
  const auto run = [&](std::ptrdiff_t k) -> LineRun& { return runs[static_cast<std::size_t>(k % count)]; };
  for (std::ptrdiff_t k = deepest + 1; k < (closed ? deepest + count : count); ++k) {
    if (run(k).depth < shallow) run(k).meant = run(k - 1).meant;
  }
  for (std::ptrdiff_t k = deepest; !closed && k-- > 0;) {
    if (run(k).depth < shallow) run(k).meant = run(k + 1).meant;
  }
}

/// Moves the samples of a run, and those next to it, to one side of the cover. Ends of open lines stay on their bars.
void move_aside(CleanLine& line, const CleanLine& cover, const SegmentGrid& grid, const LineRun& run, double shallow) {
  const int side = (signed_area(cover.points) > 0) == run.meant ? 1 : -1;
  const double distance = moved_share * shallow;
  for (auto i = static_cast<Index>(run.begin); i <= std::ceil(run.end); ++i) {
    if (!line.closed && (i == 0 || i + 1 >= line.points.size())) continue;
    Vec2& point = line.points[i % line.points.size()];
    const std::optional<SegmentGrid::Place> nearest = grid.nearest(point, 2 * shallow);
    if (!nearest || (encloses(cover.points, point) == run.meant && nearest->distance >= distance)) continue;
    point = nearest->at + side * distance * left_of((nearest->segment.b - nearest->segment.a).normalized());
  }
}

/// Runs that stay near to a closed line are moved to its other side.
/// @returns one of the places where the two are meant to cross
std::optional<Vec2> settle_crossings(CleanLine& line, const CleanLine& cover, double shallow, double step) {
  const SegmentGrid grid(segments_of(std::vector{cover}), step);
  const std::vector<double> crossings = crossing_parameters(line, cover, step);
  // A closed line can't enter another one more often than it leaves it, unless one of them crosses itself.
  if (crossings.empty() || (line.closed && crossings.size() % 2 != 0)) return std::nullopt;
  std::vector<LineRun> runs = runs_between(crossings, line, cover);
  for (LineRun& run : runs) {
    for (auto i = static_cast<Index>(std::ceil(run.begin)); i <= run.end && run.depth < 2 * shallow; ++i) {
      const auto nearest = grid.nearest(line.points[i % line.points.size()], 2 * shallow);
      run.depth = std::max(run.depth, nearest ? nearest->distance : 2 * shallow);
    }
  }
  join_shallow_runs(runs, line.closed, shallow);
  for (const LineRun& run : runs) {
    if (run.meant != run.inside) move_aside(line, cover, grid, run, shallow);
  }
  const auto other = std::ranges::find(runs, !runs.front().meant, &LineRun::meant);
  return other == runs.end() ? std::nullopt : std::optional(point_at(line.points, other->begin));
}

Finding warning(const Drawing& drawing, const CrossingInView& pair) {
  const std::string front = in_quotes(drawing, pair.front);
  const std::string behind = in_quotes(drawing, pair.behind);
  const std::string why = pair.chosen ? "as it is told" : "if it lies behind, let it stop at the other one";
  return make_warning(
      Category::Geometry, "W_CROSS",
      front + " and " + behind + " cross in full view: " + front + " is read as the one in front; " + why,
      {stroke_subject(drawing, pair.front, pair.at), stroke_subject(drawing, pair.behind, pair.at),
       crossing_subject(drawing, pair.at)});
}

// What is left.

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
  const std::string first = in_quotes(drawing, s1);
  const bool crossing = is_crossing(contact), itself = s1 == s2;
  std::string sentence = itself ? first : first + " and " + in_quotes(drawing, s2);
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
  LineFinding result{make_error(Category::Geometry, crossing ? "E_CROSS" : "E_TOUCH", sentence, std::move(subjects)),
                     {contact.a.line}};
  if (contact.b.line != contact.a.line) result.lines.push_back(contact.b.line);
  return result;
}

}  // namespace

VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress) {
  VisibleCrossings found;
  found.sides.resize(lines.size(), 0);
  for (const Cover& cover : covers_of(drawing, lines, crossing_pairs(lines, scale), tubes_only)) {
    progress.check();
    CleanLine& line = lines[cover.behind];
    const CleanLine& front = lines[cover.front];
    const bool grown = line.grows() || front.grows();
    const double shallow = grown ? 0 : scale.shallow(std::min(line.size, front.size));  // a limb's end may cover little
    const std::optional<Vec2> at = settle_crossings(line, front, shallow, scale.step);
    if (!at) continue;
    found.in_front.emplace(cover.front, cover.behind);
    found.behind.insert(cover.behind);
    found.sides[cover.front] = (signed_area(front.points) > 0) != cover.is_hole ? 1 : -1;
    if (cover.is_hole) continue;
    const bool whole = line.closed && front.closed && !front.bridged;
    found.pairs.push_back({last_stroke(front), last_stroke(line), *at, cover.chosen, whole, grown});
  }
  std::ranges::sort(found.pairs, {}, [](const CrossingInView& pair) { return std::pair(pair.front, pair.behind); });
  for (const CrossingInView& pair : found.pairs) {
    if (!pair.grown) found.findings.push_back(warning(drawing, pair));
  }
  return found;
}

LineFindings find_line_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                 const std::vector<HiddenEnd>& ends, const VisibleCrossings& order,
                                 const DrawingScale& scale, const Progress& progress) {
  const double reach = touch_distance * scale.unit;
  std::map<std::pair<Index, Index>, SegmentContact> worst;  // by strokes; a crossing counts as worse than a touch
  for (const SegmentContact& contact : find_contacts(SegmentGrid(segments_of(lines), scale.step), reach)) {
    progress.check();
    const auto& [a, b] = std::tie(contact.a, contact.b);
    const double apart = a.line == b.line ? separation(lines[a.line], a.position, b.position) : own_segments + 1;
    if (order.is_known(a.line, b.line) || (!contact.crosses() && apart <= own_segments)) continue;
    if (is_junction(lines, ends, a, b) || is_junction(lines, ends, b, a)) continue;
    const auto strokes = std::minmax({lines[a.line].stroke[a.position], lines[b.line].stroke[b.position]});
    const auto [place, fresh] = worst.try_emplace(strokes, contact);
    if (!fresh && is_crossing(contact) && !is_crossing(place->second)) place->second = contact;
  }
  LineFindings findings;
  for (const auto& [strokes, contact] : worst) {
    findings.push_back(describe(drawing, strokes.first, strokes.second, contact));
  }
  return findings;
}

LinePairs crossing_pairs(const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  LinePairs pairs;
  for (const auto& contact : find_contacts(SegmentGrid(segments_of(lines), scale.step))) {
    if (contact.a.line != contact.b.line) pairs.emplace(contact.a.line, contact.b.line);
  }
  return pairs;
}

}  // namespace croquis::silhouette
