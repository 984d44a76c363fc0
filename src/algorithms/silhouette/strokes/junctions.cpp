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

#include "algorithms/silhouette/strokes/bar_search.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/ends_beside.h"
#include "algorithms/silhouette/strokes/line_conflicts.h"
#include "algorithms/silhouette/strokes/tremble.h"

namespace croquis::silhouette {
namespace {

// A stem that meets its bar flatter than this sine is turned to it: its completion would cross the bar again.
constexpr double least_junction_sine = 0.3;
// A stem goes on behind its bar by this much (u).
constexpr double extension = 1.5;
// No sample lies nearer to the end of a trimmed line than this share of a step.
constexpr double least_junction_spacing = 0.3;

// Ends that touch nothing within reach are tried with so many times it.
constexpr std::array<double, 3> farther_reach{1, 1.5, 2.25};

/// What an end meets that may miss it by more than usual: nothing farther than needed, unless it crosses something
/// farther back.
std::optional<BarHit> find_farther(const BarSearch& bars, Index line, bool at_start, EndReach reach) {
  std::optional<BarHit> hit;
  for (const double factor : farther_reach) {
    reach.factor = factor;
    if (!hit) hit = bars.find(line, at_start, reach);
  }
  const std::optional<BarHit> deep = bars.find(line, at_start, reach);
  return deep && deep->along < 0 && (!hit || deep->along < hit->along) ? deep : hit;
}

/// @param most_back how far from its end a line is searched for what it crosses
EndHits search(const std::vector<CleanLine>& lines, const StrokeReading& reading, const DrawingScale& scale,
               double most_back, const Progress& progress) {
  const BarSearch bars(lines, scale);
  EndHits hits(lines.size());
  const auto find = [&](Index line, bool at_start) {
    const Index stroke = lines[line].end_stroke(at_start);
    const bool farther = std::find(reading.farther.begin(), reading.farther.end(), stroke) != reading.farther.end();
    EndReach reach{most_back, 1, {}};
    for (const EndElsewhere& told : reading.elsewhere) {
      if (told.end == StrokeEnd{stroke, at_start}) reach.elsewhere.push_back(told.bar);
    }
    return farther ? find_farther(bars, line, at_start, reach) : bars.find(line, at_start, reach);
  };
  for (Index line = 0; line < lines.size(); ++line) {
    progress.check();
    if (!lines[line].closed) hits[line] = {find(line, true), find(line, false)};
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
                   const DrawingScale& scale) {
  const double parameter = current_parameter(lines[hit.bar], hit.parameter, hit.at);
  HiddenEnd end{line, at_start, hit.bar, parameter, hit.at, Vec2::Zero(), 1};
  const Points& points = lines[line].points;
  const Points& bar = lines[hit.bar].points;
  const auto segment = static_cast<std::size_t>(parameter);
  const Vec2 direction = (bar[(segment + 1) % bar.size()] - bar[segment]).normalized();
  end.tangent = end_direction(lines[line], at_start, scale);
  const double sine = cross(direction, end.tangent);
  end.bar_side = sine >= 0 ? 1 : -1;
  if (std::abs(sine) >= least_junction_sine) return end;
  // Too flat for the tangent to decide: the stem comes from the side where its last samples lie.
  const Vec2 inward = -end_chord(points, at_start, 3 * scale.step);
  const double from = cross(direction, inward);
  if (std::abs(from) > std::abs(sine)) end.bar_side = from > 0 ? -1 : 1;
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

std::vector<std::array<bool, 2>> meet_bars(std::vector<CleanLine>& lines, const StrokeReading& reading,
                                           const DrawingScale& scale, const Progress& progress) {
  EndHits hits = search(lines, reading, scale, std::numeric_limits<double>::infinity(), progress);
  pass_beside_ends(lines, scale, hits);
  move_ends(lines, hits, scale);
  std::vector<std::array<bool, 2>> loose(lines.size(), {false, false});
  for (Index line = 0; line < lines.size(); ++line) {
    if (!lines[line].closed) loose[line] = {!hits[line][0], !hits[line][1]};
  }
  return loose;
}

Junctions find_junctions(const Drawing& drawing, std::vector<CleanLine>& lines, const StrokeReading& reading,
                         std::vector<HiddenPiece> pieces, const DrawingScale& scale, const Progress& progress) {
  // Once more on the trimmed lines: a bar may have lost the bit that a stem ended on.
  const EndHits hits = search(lines, reading, scale, least_junction_spacing * scale.step, progress);
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
        junctions.ends.push_back(junction(lines, line, at_start, *hit, scale));
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
