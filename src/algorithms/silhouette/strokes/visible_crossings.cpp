// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/visible_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// A ring is as wide as at this quantile of its width, and even where it is no wider than that by this factor.
constexpr double width_quantile = 0.2;
constexpr double even_factor = 1.6;
// Share of an outline along which its ring must be even.
constexpr double even_share = 0.6;
// Largest width of a ring for the radius of its hole, by how much speaks for a part: nothing, one, two, more things.
constexpr std::array<double, 4> widest_ring{1.2, 0.8, 0.62, 0.5};
// A ring that nothing speaks against may be this wide where it is even all round: a doughnut.
constexpr double widest_round_ring = 2.2;
constexpr double round_factor = 1.5;
// Samples of an outline that are measured: enough for its shape.
constexpr std::size_t measured_samples = 64;
// In parts of its size: how deep a line is led into its neighbour, and how far to either side of where it is nearest it
// is moved.
constexpr double led_depth = 0.12;
constexpr double led_width = 0.25;
// Closed lines that come nearer than this (u) are moved apart.
constexpr double touching = 0.2;
// Samples on the wrong side are moved to this share of what counts as shallow on the right one.
constexpr double moved_share = 0.5;

using LinePairs = std::set<std::pair<Index, Index>>;

/// Pairs of lines that cross, and of closed ones that touch; the lower index first.
LinePairs crossing_pairs(const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  LinePairs pairs;
  for (const auto& contact : find_contacts(SegmentGrid(segments_of(lines), scale.step), touching * scale.unit)) {
    const Index a = contact.a.line, b = contact.b.line;
    if (a != b && (contact.crosses() || (lines[a].closed && lines[b].closed))) pairs.emplace(a, b);
  }
  return pairs;
}

/// Where a line comes nearest to another one, or deepest into it.
struct Approach {
  std::size_t point = 0;                                      ///< of the line
  double distance = std::numeric_limits<double>::infinity();  ///< negative within the other one
  Vec2 direction = Vec2::Zero();                              ///< unit: into the other one
};

/// @param reach no farther and no deeper than that
Approach approach_of(const CleanLine& line, const CleanLine& other, double reach) {
  const SegmentGrid grid(segments_of_lines(other), reach);
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
  const auto& [smaller, larger] = a.size < b.size ? std::tie(a, b) : std::tie(b, a);
  const double shallow = scale.shallow(smaller.size);
  return a.closed && b.closed && approach_of(smaller, larger, shallow).distance > -shallow;
}

/// Lines that end at one another, or cross, are one thing: per line the first one of its thing.
std::vector<Index> things_of(const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  DisjointSets things(lines.size());
  for (Index line = 0; line < lines.size(); ++line) {
    for (const std::optional<EndTarget>& target : lines[line].targets) {
      if (target) things.unite(line, target->bar);
    }
  }
  for (const auto& [a, b] : crossing_pairs(lines, scale)) {
    if (!lie_beside(lines[a], lines[b], scale)) things.unite(a, b);
  }
  return things.take_roots();
}

void lead(CleanLine& line, const Approach& approach) {
  const std::vector<double> arcs = arc_lengths(line.points, true);
  const double width = led_width * line.size;
  const Vec2 way = (approach.distance + led_depth * line.size) * approach.direction;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double along = std::abs(arcs[i] - arcs[approach.point]);
    const double away = std::min(along, arcs.back() - along) / width;
    if (away < 1) line.points[i] += (1 + std::cos(std::numbers::pi * away)) / 2 * way;
  }
  line.led = true;
}

// Which of two lines lies in front.

/// The smallest closed line around another one that doesn't cross it, or no_index.
Index line_around(const std::vector<CleanLine>& lines, const LinePairs& crossing, Index line) {
  const auto area = [&](Index i) { return std::abs(signed_area(lines[i].points)); };
  Index around = no_index;
  for (Index other = 0; other < lines.size(); ++other) {
    if (lines[other].centre_line != no_index) continue;
    if (!lines[other].closed || crossing.contains(std::minmax(line, other)) || area(other) <= area(line)) continue;
    if (around != no_index && area(other) >= area(around)) continue;
    if (encloses(lines[other].points, lines[line].points.front())) around = other;
  }
  return around;
}

/// The closed line that another closed one is a hole of, else the line itself. The stroke's own "kind" decides, else
/// the shape of the ring between the two.
Index ring_of(const Drawing& drawing, const std::vector<CleanLine>& lines, const LinePairs& crossing, Index line) {
  const Index around = lines[line].centre_line != no_index ? no_index : line_around(lines, crossing, line);
  if (around == no_index) return line;
  const auto things = std::ranges::count_if(
      crossing, [around](const auto& pair) { return pair.first == around || pair.second == around; });
  const std::optional<bool> by_kind = hole_by_kind(drawing, lines[line].strokes);
  const bool hole =
      by_kind ? *by_kind : is_hole_of_ring(lines[line].points, lines[around].points, static_cast<std::size_t>(things));
  return hole ? around : line;
}

Index last_stroke(const CleanLine& line) { return std::ranges::max(line.strokes); }

bool is_set_behind_line(const Drawing& drawing, const CleanLine& line, const CleanLine& other) {
  return std::ranges::any_of(line.strokes, [&](Index s) {
    return std::ranges::any_of(other.strokes,
                               [&](Index t) { return is_set_behind(drawing.strokes[s], drawing.strokes[t]); });
  });
}

/// The ends of an outline that was left open are seen within what it lies in front of.
bool opens_within(const CleanLine& line, const CleanLine& other) {
  return line.bridged && encloses(other.points, (line.points.front() + line.points.back()) / 2);
}

/// A line in front of another one.
struct Cover {
  Index front = 0;
  Index behind = 0;
  bool chosen = false;   ///< by what the strokes say
  bool is_hole = false;  ///< of a ring, whose outline counts instead
};

std::vector<Cover> covers_of(const Drawing& drawing, const std::vector<CleanLine>& lines, const LinePairs& crossing,
                             bool tubes_only) {
  std::vector<Index> rings(lines.size(), no_index);  // of closed lines that cross closed ones
  const auto ring = [&](Index line) -> const CleanLine& {
    if (rings[line] == no_index) rings[line] = ring_of(drawing, lines, crossing, line);
    return lines[rings[line]];
  };
  std::vector<Cover> covers;
  for (const auto& [a, b] : crossing) {
    const bool are_closed = lines[a].closed && lines[b].closed;
    if (tubes_only && !lines[a].grows() && !lines[b].grows()) continue;
    if (!lines[a].closed && !lines[b].closed) continue;
    if (lines[a].centre_line != no_index && lines[b].centre_line != no_index) continue;  // see find_passings
    Cover& cover = covers.emplace_back(Cover{a, b});
    const bool is_later = are_closed ? last_stroke(ring(b)) >= last_stroke(ring(a)) : lines[b].closed;
    if (is_later) std::swap(cover.front, cover.behind);
    if (!are_closed) continue;
    const CleanLine &later = ring(cover.front), &earlier = ring(cover.behind);
    const bool later_is_behind = is_set_behind_line(drawing, later, earlier);
    cover.chosen = later_is_behind || is_set_behind_line(drawing, earlier, later);
    const bool earlier_opens = opens_within(earlier, later) && !opens_within(later, earlier);
    if (later_is_behind || earlier_opens) std::swap(cover.front, cover.behind);
    cover.is_hole = rings[cover.front] != cover.front;
  }
  // Lines are moved where they nearly touch, those in front first; what crosses then was meant to.
  std::ranges::stable_sort(covers, std::greater(),
                           [&](const Cover& cover) { return last_stroke(lines[cover.behind]); });
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

/// The runs between crossings, which ascend. Sides alternate; the longest run shows which one is inside.
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

/// Runs that stay near to a closed line are moved to its other side, and a line that only touches it is moved off it.
/// @returns one of the places where the two are meant to cross
std::optional<Vec2> settle_crossings(CleanLine& line, const CleanLine& cover, double shallow, double step) {
  const SegmentGrid grid(segments_of_lines(cover), step);
  std::vector<double> crossings;  // parameters
  for (const SegmentContact& contact : find_contacts(SegmentGrid(segments_of_lines(line, cover), step))) {
    if (contact.a.line != contact.b.line) crossings.push_back(contact.a.position + contact.fraction_a);
  }
  std::ranges::sort(crossings);
  if (crossings.empty()) {
    const bool inside = encloses(cover.points, line.points.front());
    move_aside(line, cover, grid, {0, static_cast<double>(line.segment_count()), inside, inside}, shallow);
    return std::nullopt;
  }
  // A closed line can't enter another one more often than it leaves it, unless one of them crosses itself.
  if (line.closed && crossings.size() % 2 != 0) return std::nullopt;
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
  const std::string why = pair.chosen ? "as it is set" : "if it lies behind, let it stop at the other one";
  return make_warning(
      Category::Geometry, "W_CROSS",
      front + " and " + behind + " cross in full view: " + front + " is read as the one in front; " + why,
      {stroke_subject(drawing, pair.front, pair.at), stroke_subject(drawing, pair.behind, pair.at),
       crossing_subject(drawing, pair.at)});
}

}  // namespace

bool is_hole_of_ring(const Points& inner, const Points& outer, std::size_t things) {
  const std::size_t step = std::max<std::size_t>(1, inner.size() / measured_samples);
  std::vector<double> widths;  // of the ring between both, ascending
  for (std::size_t i = 0; i < inner.size(); i += step) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const Vec2 nearest = nearest_on_segment(inner[i], outer[k], outer[(k + 1) % outer.size()]);
      least = std::min(least, (nearest - inner[i]).norm());
    }
    widths.push_back(least);
  }
  std::ranges::sort(widths);
  const double width = widths[static_cast<std::size_t>(width_quantile * static_cast<double>(widths.size()))];
  const auto even = std::upper_bound(widths.begin(), widths.end(), even_factor * width) - widths.begin();
  const double radius = 2 * std::abs(signed_area(inner)) / length(inner, true);
  const bool round = widths.back() <= round_factor * widths.front() && width <= widest_round_ring * radius;
  if (things == 0 && round) return true;
  const double widest = widest_ring[std::min(things, widest_ring.size() - 1)];
  return static_cast<double>(even) >= even_share * static_cast<double>(widths.size()) && width <= widest * radius;
}

std::optional<bool> hole_by_kind(const Drawing& drawing, const std::vector<Index>& strokes) {
  for (const Index stroke : strokes) {
    const StrokeKind kind = stroke_kind(drawing.strokes[stroke]).value_or(StrokeKind::Visible);
    if (kind == StrokeKind::Hole) return true;
    if (kind == StrokeKind::Part || kind == StrokeKind::Blob) return false;
  }
  return std::nullopt;
}

bool is_set_behind(const Drawing& drawing, const std::vector<Index>& strokes, const std::vector<Index>& others) {
  return std::ranges::any_of(strokes, [&](Index s) {
    const std::vector<std::string_view> ids = behind_ids(drawing.strokes[s]);
    return !ids.empty() && std::ranges::any_of(others, [&](Index other) {
      return std::ranges::count(ids, drawing.strokes[other].id) > 0;
    });
  });
}

void lead_into_neighbours(std::vector<CleanLine>& lines, const DrawingScale& scale) {
  if (scale.reach_share <= 0) return;
  const std::vector<Index> thing = things_of(lines, scale);
  std::vector<Eigen::AlignedBox2d> boxes(lines.size());
  for (Index i = 0; i < lines.size(); ++i) {
    for (const Vec2& point : lines[i].points) boxes[i].extend(point);
  }
  for (Index a = 0; a < lines.size(); ++a) {
    CleanLine& line = lines[a];
    const auto is_around = [&](const CleanLine& other) {
      const auto is_inside = [&](const Vec2& point) { return encloses(other.points, point); };
      return &other != &line && other.closed && std::ranges::all_of(line.points, is_inside);
    };
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

VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress) {
  VisibleCrossings found;
  for (Index line = 0; line < lines.size(); ++line) {
    found.sides.push_back(lines[line].side);
    if (lines[line].centre_line != no_index) found.behind.insert(line);
  }
  for (const Cover& cover : covers_of(drawing, lines, crossing_pairs(lines, scale), tubes_only)) {
    progress.check();
    CleanLine& line = lines[cover.behind];
    const CleanLine& front = lines[cover.front];
    const bool grown = line.grows() || front.grows();
    const bool stays = grown || line.centre_line != no_index || front.centre_line != no_index;
    const double shallow = stays ? 0 : scale.shallow(std::min(line.size, front.size));  // a limb's end may cover little
    const std::optional<Vec2> at = settle_crossings(line, front, shallow, scale.step);
    if (!at) continue;
    found.in_front.emplace(cover.front, cover.behind);
    found.behind.insert(cover.behind);
    if (front.centre_line == no_index)
      found.sides[cover.front] = (signed_area(front.points) > 0) != cover.is_hole ? 1 : -1;
    const auto is_named = [&](const CrossingInView& pair) {  // by another outline of the same tube
      return pair.front == last_stroke(front) && pair.behind == last_stroke(line);
    };
    if (cover.is_hole || grown || (stays && std::ranges::any_of(found.pairs, is_named))) continue;
    const bool whole = line.closed && front.closed && !front.bridged;
    found.pairs.push_back({last_stroke(front), last_stroke(line), *at, cover.chosen, whole});
  }
  std::ranges::sort(found.pairs, {}, [](const CrossingInView& pair) { return std::pair(pair.front, pair.behind); });
  for (const CrossingInView& pair : found.pairs) found.findings.push_back(warning(drawing, pair));
  return found;
}

}  // namespace croquis::silhouette
