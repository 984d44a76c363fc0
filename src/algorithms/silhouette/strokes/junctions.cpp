// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/jitter.h"

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

/// Makes the last sample of a line the place of a hit.
void move_end(CleanLine& line, const EndHit& hit, double step) {
  const Index stroke = line.stroke.back();
  auto kept = static_cast<Index>(line.points.size());
  if (hit.along < 0) kept = static_cast<Index>(std::ceil(parameter_along(line.points, false, -hit.along)));
  while (kept > 1 && (line.points[kept - 1] - hit.at).norm() < least_junction_spacing * step) --kept;
  line.keep(0, std::max<Index>(kept, 1));
  line.points.push_back(hit.at);
  line.raw.push_back(hit.at);
  line.stroke.push_back(stroke);
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

/// Hands the strokes that are told to be hidden to the ends that they join. Those leave along them.
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
  const auto refuse = [&](const SampledStroke& stroke, const std::string& why, const Vec2& at) {
    junctions.findings.push_back({make_error(Category::Geometry, "E_HIDDEN_STROKE",
                                             "The hidden stroke " + in_quotes(drawing, stroke.stroke) + " " + why,
                                             {stroke_subject(drawing, stroke.stroke, at)}),
                                  {}});
  };
  for (const SampledStroke& stroke : hidden) {
    Points points = even_points(stroke.points, false, std::min(scale.step, stroke.length / 4));
    if (stroke.closed) {
      refuse(stroke, "is closed: draw it from where a line passes behind something to where it comes out",
             points.front());
      continue;
    }
    const double farthest = std::max(scale.gap, farthest_share * stroke.length);
    const Index from = nearest_end(points.front(), farthest, no_index);
    const Index to = nearest_end(points.back(), farthest, from);
    if (from == no_index || to == no_index) {
      refuse(stroke, "begins or ends where no line does that it could go on from: draw it up to one",
             from == no_index ? points.front() : points.back());
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
    std::vector<Index> strokes(points.size(), stroke.stroke);
    junctions.given.push_back({from, to, std::move(points), std::move(strokes)});
  }
}

LineFinding free_end(const Drawing& drawing, const CleanLine& line, Index index, bool at_start) {
  const Index stroke = line.end_stroke(at_start);
  return {no_solid("the end of " + in_quotes(drawing, stroke) + " touches nothing that it could pass behind",
                   {stroke_subject(drawing, stroke, line.end(at_start))}),
          {index}};
}

LineFinding two_sided(const Drawing& drawing, const std::vector<CleanLine>& lines, Index bar,
                      const std::vector<HiddenEnd>& stems) {
  const HiddenEnd& first = stems.front();
  const Index on_bar = lines[bar].stroke[static_cast<std::size_t>(first.bar_parameter)];
  std::vector<Subject> subjects{stroke_subject(drawing, on_bar, first.at)};
  std::vector<Index> all{bar};
  for (const HiddenEnd& stem : stems) {
    subjects.push_back(stroke_subject(drawing, lines[stem.line].end_stroke(stem.at_start), stem.at));
    all.push_back(stem.line);
  }
  return {no_solid("lines pass behind " + in_quotes(drawing, on_bar) +
                       " on both of its sides, of which only one can be its surface",
                   std::move(subjects)),
          std::move(all)};
}

/// Williams' rule: a stem goes under its bar, so the bar's surface lies where the stem is heading.
void decide_sides(const Drawing& drawing, const std::vector<CleanLine>& lines, Junctions& junctions) {
  std::vector<std::vector<HiddenEnd>> stems(lines.size());
  for (const HiddenEnd& end : junctions.ends) stems[end.bar].push_back(end);
  for (Index bar = 0; bar < lines.size(); ++bar) {
    if (stems[bar].empty()) continue;
    const int side = junctions.sides[bar] != 0 ? junctions.sides[bar] : stems[bar].front().bar_side;
    if (std::ranges::all_of(stems[bar], [side](const HiddenEnd& stem) { return stem.bar_side == side; })) {
      junctions.sides[bar] = side;
    } else {
      junctions.findings.push_back(two_sided(drawing, lines, bar, stems[bar]));
    }
  }
}

}  // namespace

void meet_bars(std::vector<CleanLine>& lines, EndTargets& targets, const DrawingScale& scale) {
  std::vector<std::array<std::optional<EndHit>, 2>> hits(targets.size());
  for (Index line = 0; line < targets.size(); ++line) {
    for (const Index k : {0U, 1U}) {
      std::optional<EndTarget>& target = targets[line][k];
      if (target) hits[line][k] = hit_of(lines, line, k == 0, *target, scale.step);
      if (!hits[line][k]) target.reset();
    }
  }
  // All hits are found before any line changes.
  for (Index line = 0; line < targets.size(); ++line) {
    for (const Index k : {1U, 0U}) {
      const std::optional<EndHit>& hit = hits[line][k];
      if (!hit) continue;
      if (k == 0) lines[line].reverse();
      move_end(lines[line], *hit, scale.step);
      if (k == 0) lines[line].reverse();
      targets[line][k]->at = hit->at;
      targets[line][k]->miss = 0;
    }
  }
}

Junctions find_junctions(const Drawing& drawing, const std::vector<CleanLine>& lines, const EndTargets& targets,
                         const std::vector<SampledStroke>& hidden, const VisibleCrossings& order,
                         const DrawingScale& scale, const Progress& progress) {
  Junctions junctions;
  junctions.jitter = scale.jitter;
  junctions.sides = order.sides;
  junctions.sides.resize(lines.size(), 0);
  for (Index line = 0; line < lines.size(); ++line) {
    if (lines[line].closed) continue;
    for (const bool at_start : {true, false}) {
      const std::optional<EndTarget>& target = targets[line][at_start ? 0 : 1];
      if (target) {
        junctions.ends.push_back(junction(lines, line, at_start, *target, scale));
      } else {
        junctions.findings.push_back(free_end(drawing, lines[line], line, at_start));
      }
    }
  }
  give_pieces(drawing, hidden, lines, scale, junctions);
  decide_sides(drawing, lines, junctions);
  LineFindings conflicts = find_line_conflicts(drawing, lines, junctions.ends, order, scale, progress);
  std::move(conflicts.begin(), conflicts.end(), std::back_inserter(junctions.findings));
  return junctions;
}

void extend_behind_bars(std::vector<CleanLine>& lines, const std::vector<HiddenEnd>& ends, const DrawingScale& scale) {
  for (const HiddenEnd& end : ends) {
    const Vec2 behind = end.at + extension * scale.unit * end.tangent;
    (end.at_start ? lines[end.line].points.front() : lines[end.line].points.back()) = behind;
  }
}

}  // namespace croquis::silhouette
