// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/line_conflicts.h"
#include "algorithms/silhouette/strokes/segment_grid.h"
#include "algorithms/silhouette/strokes/tremble.h"

namespace croquis::silhouette {
namespace {

// A stem that meets its bar flatter than this sine is turned to it: its completion would cross the bar again.
constexpr double least_junction_sine = 0.3;
// A stem goes on behind its bar by this much (u).
constexpr double extension = 1.5;
// No sample lies nearer to the end of a trimmed line than this share of a step.
constexpr double least_junction_spacing = 0.3;

// An end lies on its bar when it is no farther from it than this share of a step.
constexpr double on_bar = 0.5;

/// Where the end of a line meets another line.
struct BarHit {
  double along = 0;  ///< arc length from the end: negative on the line (overshoot), positive ahead of it
  Index bar = 0;
  double parameter = 0;  ///< on the bar
  Vec2 at = Vec2::Zero();
};

using EndHits = std::vector<std::array<std::optional<BarHit>, 2>>;

/// A line passes behind its own other parts, not behind its end.
bool is_own_end(const CleanLine& line, bool at_start, Index position, double clear) {
  double length = 0;
  const Index count = line.segment_count();
  for (Index i = 0; i < count && length < clear; ++i) {
    const Index segment = at_start ? i : count - 1 - i;
    if (segment == position) return true;
    length += (line.points[segment + 1] - line.points[segment]).norm();
  }
  return false;
}

/// The place on its bar that is nearest to where an end was seen to meet it: what its last bit crosses, what lies ahead
/// of it, or what lies beside it.
std::optional<BarHit> hit_of(const std::vector<CleanLine>& lines, Index line, bool at_start, const EndTarget& target,
                             double step) {
  Points own = lines[line].points;
  if (!at_start) std::reverse(own.begin(), own.end());
  const double far = std::max(3 * target.miss, 4 * step);
  const Vec2 ahead = own.front() + far * end_tangent(own, true, tangent_steps * step);
  const CleanLine& bar = lines[target.bar];
  std::optional<BarHit> best;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < bar.segment_count(); ++i) {
    if (target.bar == line && is_own_end(bar, at_start, i, far)) continue;
    const Vec2& a = bar.points[i];
    const Vec2& b = bar.points[(i + 1) % bar.points.size()];
    const auto consider = [&](double along, const Vec2& at, double more) {
      const double distance = (at - target.at).norm() + more;
      if (distance >= least) return;
      least = distance;
      best = BarHit{along, target.bar, i + std::min(nearest_parameter(at, a, b), 1 - 1e-9), at};
    };
    double walked = 0;
    for (std::size_t k = 0; k + 1 < own.size() && walked < far; ++k) {
      const Vec2 piece = own[k + 1] - own[k];
      if (cross_properly(own[k], own[k + 1], a, b)) {
        const double fraction = crossing_fraction(own[k], own[k + 1], a, b);
        consider(-(walked + fraction * piece.norm()), own[k] + fraction * piece, 0);
      }
      walked += piece.norm();
    }
    if (cross_properly(own.front(), ahead, a, b)) {
      const double fraction = crossing_fraction(own.front(), ahead, a, b);
      consider(fraction * far, own.front() + fraction * (ahead - own.front()), step / 2);
    }
    const Vec2 nearest = a + nearest_parameter(own.front(), a, b) * (b - a);
    consider((nearest - own.front()).norm(), nearest, step + (nearest - own.front()).norm());
  }
  return best;
}

/// The line on which an end lies.
EndHits lines_at_ends(const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  const double reach = on_bar * scale.step;
  const SegmentGrid grid(line_segments(lines), scale.step, reach);
  EndHits hits(lines.size());
  for (Index line = 0; line < lines.size(); ++line) {
    for (const bool at_start : {true, false}) {
      if (lines[line].closed) continue;
      const Vec2& place = lines[line].end(at_start);
      const Vec2 around = Vec2::Constant(reach);
      double least = reach;
      grid.near_box(place - around, place + around, [&](Index i) {
        const GridSegment& segment = grid.segments()[i];
        if (segment.line == line && is_own_end(lines[line], at_start, segment.position, 3 * scale.step)) return;
        const double fraction = nearest_parameter(place, segment.a, segment.b);
        const Vec2 nearest = segment.a + fraction * (segment.b - segment.a);
        const double distance = (nearest - place).norm();
        if (distance >= least) return;
        least = distance;
        hits[line][at_start ? 0 : 1] =
            BarHit{distance, segment.line, segment.position + std::min(fraction, 1 - 1e-9), nearest};
      });
    }
  }
  return hits;
}

void reverse(CleanLine& line) {
  std::reverse(line.points.begin(), line.points.end());
  std::reverse(line.stroke.begin(), line.stroke.end());
  std::reverse(line.raw.begin(), line.raw.end());
}

/// Makes the last sample of a line the place of a hit.
void move_end(CleanLine& line, const BarHit& hit, double step) {
  const Index stroke = line.stroke.back();
  const auto drop_last = [&line] {
    line.points.pop_back();
    line.stroke.pop_back();
  };
  double excess = -hit.along;
  while (excess > 0 && line.points.size() > 2) {
    const double length = (line.points.back() - line.points[line.points.size() - 2]).norm();
    if (length > excess) break;
    excess -= length;
    drop_last();
  }
  if (excess > 0) drop_last();
  while (line.points.size() > 1 && (line.points.back() - hit.at).norm() < least_junction_spacing * step) drop_last();
  line.points.push_back(hit.at);
  line.stroke.push_back(stroke);
}

/// Cuts or extends the strokes as drawn so that they end where the cleaned line does.
void move_raw_end(CleanLine& line, const Vec2& at, double reach) {
  Points& raw = line.raw;
  double best = (raw.back() - at).norm();
  std::size_t keep = raw.size();
  double walked = 0;
  for (std::size_t i = raw.size() - 1; i > 0 && walked < reach; --i) {
    const Vec2 nearest = raw[i - 1] + nearest_parameter(at, raw[i - 1], raw[i]) * (raw[i] - raw[i - 1]);
    if ((nearest - at).norm() < best) {
      best = (nearest - at).norm();
      keep = i;
    }
    walked += (raw[i] - raw[i - 1]).norm();
  }
  raw.resize(std::max<std::size_t>(keep, 1));
  raw.push_back(at);
}

void move_ends(std::vector<CleanLine>& lines, const EndHits& hits, const DrawingScale& scale) {
  for (Index i = 0; i < lines.size(); ++i) {
    for (const bool at_start : {false, true}) {
      const std::optional<BarHit>& hit = hits[i][at_start ? 0 : 1];
      if (!hit) continue;
      if (at_start) reverse(lines[i]);
      move_end(lines[i], *hit, scale.step);
      move_raw_end(lines[i], hit->at, 3 * std::max(scale.snap, std::abs(hit->along)));
      if (at_start) reverse(lines[i]);
    }
  }
}

/// Where a place lies on a bar whose start may have been trimmed since `parameter` was found.
double current_parameter(const CleanLine& bar, double parameter, const Vec2& at) {
  constexpr std::int64_t window = 16;
  const auto count = static_cast<std::int64_t>(bar.segment_count());
  const auto near = static_cast<std::int64_t>(parameter);
  double best = std::numeric_limits<double>::infinity();
  double found = 0;
  for (std::int64_t k = near - window; k <= near + window; ++k) {
    const std::int64_t i = bar.closed ? (k % count + count) % count : std::clamp<std::int64_t>(k, 0, count - 1);
    const Vec2& a = bar.points[static_cast<std::size_t>(i)];
    const Vec2& b = bar.points[static_cast<std::size_t>(i + 1) % bar.points.size()];
    const double fraction = nearest_parameter(at, a, b);
    const double distance = (a + fraction * (b - a) - at).norm();
    if (distance < best) {
      best = distance;
      found = static_cast<double>(i) + std::min(fraction, 1 - 1e-9);
    }
  }
  return found;
}

/// The junction of a line that ends on its bar.
HiddenEnd junction(const std::vector<CleanLine>& lines, Index line, bool at_start, const BarHit& hit,
                   const std::vector<MetBar>& met, const DrawingScale& scale) {
  const double parameter = current_parameter(lines[hit.bar], hit.parameter, hit.at);
  HiddenEnd end{line, at_start, hit.bar, parameter, hit.at, Vec2::Zero(), 1};
  const Points& points = lines[line].points;
  const Points& bar = lines[hit.bar].points;
  const auto segment = static_cast<std::size_t>(parameter);
  const Vec2 direction = (bar[(segment + 1) % bar.size()] - bar[segment]).normalized();
  end.tangent = end_direction(lines[line], at_start, scale);
  const double sine = cross(direction, end.tangent);
  end.bar_side = sine >= 0 ? 1 : -1;
  const auto known = std::ranges::min_element(met, {}, [&](const MetBar& other) { return (other.at - hit.at).norm(); });
  if (known != met.end() && (known->at - hit.at).norm() < on_bar * scale.step) {
    end.bar_side = cross(direction, known->into) >= 0 ? 1 : -1;
  } else if (std::abs(sine) < least_junction_sine) {
    // Too flat for the tangent to decide: the stem comes from the side where its last samples lie.
    const double from = cross(direction, -end_chord(points, at_start, 3 * scale.step));
    if (std::abs(from) > std::abs(sine)) end.bar_side = from > 0 ? -1 : 1;
  }
  if (end.bar_side * sine >= least_junction_sine) return end;
  const double ahead = end.tangent.dot(direction) >= 0 ? 1 : -1;
  end.tangent = ahead * std::sqrt(1 - least_junction_sine * least_junction_sine) * direction +
                end.bar_side * least_junction_sine * left_of(direction);
  return end;
}

Index end_of_piece(const HiddenPiece::End& piece, const Junctions& junctions) {
  const auto found = std::find_if(junctions.ends.begin(), junctions.ends.end(), [&](const HiddenEnd& end) {
    return end.line == piece.line && end.at_start == piece.at_start;
  });
  return found == junctions.ends.end() ? no_index : static_cast<Index>(found - junctions.ends.begin());
}

/// The ends of a known piece leave along it.
void follow(const Points& piece, int bar_side, double distance, const std::vector<CleanLine>& lines, HiddenEnd& end) {
  double walked = 0;
  std::size_t i = 1;
  while (i + 1 < piece.size() && walked + (piece[i] - piece[i - 1]).norm() < distance) {
    walked += (piece[i] - piece[i - 1]).norm();
    ++i;
  }
  const Vec2 step = piece[i] - piece[i - 1];
  const Vec2 ahead = piece[i - 1] + std::min(1.0, (distance - walked) / step.norm()) * step;
  end.tangent = (ahead - end.at).normalized();
  end.bar_side = bar_side;
  if (bar_side != 0) return;
  const Points& bar = lines[end.bar].points;
  const auto segment = static_cast<std::size_t>(end.bar_parameter);
  end.bar_side = cross(bar[(segment + 1) % bar.size()] - bar[segment], end.tangent) >= 0 ? 1 : -1;
}

/// Hands the known hidden pieces to the ends that they join; one whose end isn't hidden after all is left out.
void give_pieces(std::vector<HiddenPiece> pieces, const std::vector<CleanLine>& lines, const DrawingScale& scale,
                 Junctions& junctions) {
  const double ahead = extension * scale.unit;
  for (HiddenPiece& piece : pieces) {
    const Index from = end_of_piece(piece.from, junctions);
    const Index to = end_of_piece(piece.to, junctions);
    if (from == no_index || to == no_index || from == to) continue;
    follow(piece.points, piece.from.bar_side, ahead, lines, junctions.ends[from]);
    follow(Points(piece.points.rbegin(), piece.points.rend()), piece.to.bar_side, ahead, lines, junctions.ends[to]);
    junctions.given.push_back({from, to, std::move(piece.points), std::move(piece.stroke)});
  }
}

LineFinding free_end(const Drawing& drawing, const CleanLine& line, Index index, bool at_start) {
  const Vec2 at = line.end(at_start);
  const Index stroke = line.end_stroke(at_start);
  return {make_error(Category::Geometry, "E_FREE_END",
                     "The end of " + in_quotes(drawing, stroke) +
                         " touches nothing: extend it to the line it passes behind, or close it",
                     {stroke_subject(drawing, stroke, at)}),
          {index}};
}

/// Whether a line whose ends touch nothing was meant to be closed: its ends are nearer than this share of its length.
bool almost_closed(const CleanLine& line) {
  constexpr double open_share = 0.25;
  return (line.end(true) - line.end(false)).norm() < open_share * croquis::length(line.points, false);
}

LineFinding not_closed(const Drawing& drawing, const CleanLine& line, Index index) {
  const Index stroke = line.end_stroke(true);
  return {make_error(Category::Geometry, "E_FREE_END",
                     "The outline " + in_quotes(drawing, stroke) +
                         " isn't closed here: let its ends meet, or extend them to the line they pass behind",
                     {stroke_subject(drawing, stroke, line.end(true)),
                      stroke_subject(drawing, line.end_stroke(false), line.end(false))}),
          {index}};
}

LineFinding two_sided(const Drawing& drawing, const std::vector<CleanLine>& lines, Index bar,
                      const std::vector<HiddenEnd>& stems) {
  const auto at = static_cast<std::size_t>(stems.front().bar_parameter);
  const Index stroke = lines[bar].stroke[std::min(at, lines[bar].stroke.size() - 1)];
  std::vector<Subject> subjects{stroke_subject(drawing, stroke)};
  std::string left;
  std::string right;
  for (const HiddenEnd& stem : stems) {
    const Index name = lines[stem.line].end_stroke(stem.at_start);
    subjects.push_back(stroke_subject(drawing, name, stem.at));
    std::string& group = stem.bar_side > 0 ? right : left;  // a stem comes from the side without surface
    if (group.find(in_quotes(drawing, name)) == std::string::npos) {
      group += (group.empty() ? "" : ", ") + in_quotes(drawing, name);
    }
  }
  LineFinding result{make_error(Category::Geometry, "E_TWO_SIDED",
                                "Lines end on both sides of " + in_quotes(drawing, stroke) +
                                    ": only one side can be its surface, so move either " + left + " or " + right,
                                std::move(subjects)),
                     {bar}};
  for (const HiddenEnd& stem : stems) result.lines.push_back(stem.line);
  return result;
}

/// Williams' rule: a stem goes under its bar, so the bar's surface lies where the stem is heading.
void decide_sides(const Drawing& drawing, const std::vector<CleanLine>& lines, Junctions& junctions) {
  std::vector<std::vector<HiddenEnd>> stems(lines.size());
  for (const HiddenEnd& end : junctions.ends) stems[end.bar].push_back(end);
  junctions.sides.assign(lines.size(), 0);
  for (Index bar = 0; bar < lines.size(); ++bar) {
    if (stems[bar].empty()) continue;
    const int side = stems[bar].front().bar_side;
    const bool agreed = std::all_of(stems[bar].begin(), stems[bar].end(),
                                    [side](const HiddenEnd& stem) { return stem.bar_side == side; });
    if (agreed) {
      junctions.sides[bar] = side;
    } else {
      junctions.findings.push_back(two_sided(drawing, lines, bar, stems[bar]));
    }
  }
}

}  // namespace

std::vector<MetBar> meet_bars(std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale) {
  std::vector<MetBar> met;
  EndHits hits(lines.size());
  for (Index line = 0; line < lines.size(); ++line) {
    for (const bool at_start : {true, false}) {
      const std::optional<EndTarget>& target = targets[line][at_start ? 0 : 1];
      if (!target) continue;
      hits[line][at_start ? 0 : 1] = hit_of(lines, line, at_start, *target, scale.step);
      if (const auto& hit = hits[line][at_start ? 0 : 1]) met.push_back({hit->at, target->into});
    }
  }
  move_ends(lines, hits, scale);
  return met;
}

Junctions find_junctions(const Drawing& drawing, std::vector<CleanLine>& lines, const std::vector<MetBar>& met,
                         std::vector<HiddenPiece> pieces, const DrawingScale& scale, const Progress& progress) {
  // Bars may have lost the bit that a stem ended on.
  const EndHits hits = lines_at_ends(lines, scale);
  move_ends(lines, hits, scale);
  Junctions junctions;
  junctions.tremble = scale.tremble;
  for (Index line = 0; line < lines.size(); ++line) {
    if (lines[line].closed) continue;
    if (!hits[line][0] && !hits[line][1] && almost_closed(lines[line])) {
      junctions.findings.push_back(not_closed(drawing, lines[line], line));
      continue;
    }
    for (const bool at_start : {true, false}) {
      const std::optional<BarHit>& hit = hits[line][at_start ? 0 : 1];
      if (hit) {
        junctions.ends.push_back(junction(lines, line, at_start, *hit, met, scale));
      } else {
        junctions.findings.push_back(free_end(drawing, lines[line], line, at_start));
      }
    }
  }
  give_pieces(std::move(pieces), lines, scale, junctions);
  decide_sides(drawing, lines, junctions);
  LineFindings conflicts = find_line_conflicts(drawing, lines, junctions.ends, scale, progress);
  std::move(conflicts.begin(), conflicts.end(), std::back_inserter(junctions.findings));
  return junctions;
}

void extend_behind_bars(std::vector<CleanLine>& lines, const std::vector<HiddenEnd>& ends, const DrawingScale& scale) {
  for (const HiddenEnd& end : ends) {
    const Vec2 behind = end.at + extension * scale.unit * end.tangent;
    (end.at_start ? lines[end.line].points.front() : lines[end.line].points.back()) = behind;
  }
}

std::vector<Index> bodies_of_limbs(const Junctions& junctions, std::size_t line_count) {
  std::vector<Index> bodies(line_count, no_index);
  // Ends are sorted by line: those of one line are neighbours.
  for (std::size_t e = 0; e + 1 < junctions.ends.size(); ++e) {
    const HiddenEnd& start = junctions.ends[e];
    const HiddenEnd& end = junctions.ends[e + 1];
    if (start.line == end.line && start.bar == end.bar && start.bar != start.line) bodies[start.line] = start.bar;
  }
  return bodies;
}

}  // namespace croquis::silhouette
