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
// A line that passes behind itself doesn't do so within so many steps of its end.
constexpr double own_end = 4;

/// Where the end of a line meets its bar.
struct BarHit {
  double along = 0;  ///< arc length from the end: negative on the line (overshoot), positive ahead of it
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
  const double far = std::max(3 * target.miss, own_end * step);
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
      best = BarHit{along, at};
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
    line.raw.pop_back();
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
  line.raw.push_back(hit.at);
  line.stroke.push_back(stroke);
}

/// Where on its bar an end lies that has met it.
double bar_parameter(const std::vector<CleanLine>& lines, Index line, bool at_start, const EndTarget& target,
                     double step) {
  const CleanLine& bar = lines[target.bar];
  double least = std::numeric_limits<double>::infinity();
  double found = 0;
  for (Index i = 0; i < bar.segment_count(); ++i) {
    if (target.bar == line && is_own_end(bar, at_start, i, own_end * step)) continue;
    const Vec2& a = bar.points[i];
    const Vec2& b = bar.points[(i + 1) % bar.points.size()];
    const double fraction = nearest_parameter(target.at, a, b);
    const double distance = (a + fraction * (b - a) - target.at).norm();
    if (distance >= least) continue;
    least = distance;
    found = i + std::min(fraction, 1 - 1e-9);
  }
  return found;
}

/// The junction of a line that ends on its bar.
HiddenEnd junction(const std::vector<CleanLine>& lines, Index line, bool at_start, const EndTarget& target,
                   const DrawingScale& scale) {
  const double parameter = bar_parameter(lines, line, at_start, target, scale.step);
  HiddenEnd end{line,       at_start, target.bar, parameter, target.at, end_direction(lines[line], at_start, scale),
                target.side};
  const Points& bar = lines[target.bar].points;
  const auto segment = static_cast<std::size_t>(parameter);
  const Vec2 direction = (bar[(segment + 1) % bar.size()] - bar[segment]).normalized();
  if (end.bar_side * cross(direction, end.tangent) >= least_junction_sine) return end;
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
void follow(const Points& piece, double distance, const std::vector<CleanLine>& lines, HiddenEnd& end) {
  double walked = 0;
  std::size_t i = 1;
  while (i + 1 < piece.size() && walked + (piece[i] - piece[i - 1]).norm() < distance) {
    walked += (piece[i] - piece[i - 1]).norm();
    ++i;
  }
  const Vec2 step = piece[i] - piece[i - 1];
  const Vec2 ahead = piece[i - 1] + std::min(1.0, (distance - walked) / step.norm()) * step;
  end.tangent = (ahead - end.at).normalized();
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
    follow(piece.points, ahead, lines, junctions.ends[from]);
    follow(Points(piece.points.rbegin(), piece.points.rend()), ahead, lines, junctions.ends[to]);
    junctions.given.push_back({from, to, std::move(piece.points), std::move(piece.stroke)});
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
  LineFinding result;
  result.lines = {bar};
  std::vector<Subject> subjects;
  const HiddenEnd& first = stems.front();
  const Index on_bar = lines[bar].stroke[static_cast<std::size_t>(first.bar_parameter)];
  subjects.push_back(stroke_subject(drawing, on_bar, first.at));
  for (const HiddenEnd& stem : stems) {
    subjects.push_back(stroke_subject(drawing, lines[stem.line].end_stroke(stem.at_start), stem.at));
    result.lines.push_back(stem.line);
  }
  result.finding = no_solid(
      "lines pass behind " + in_quotes(drawing, on_bar) + " on both of its sides, of which only one can be its surface",
      std::move(subjects));
  return result;
}

/// Williams' rule: a stem goes under its bar, so the bar's surface lies where the stem is heading.
void decide_sides(const Drawing& drawing, const std::vector<CleanLine>& lines, Junctions& junctions) {
  std::vector<std::vector<HiddenEnd>> stems(lines.size());
  for (const HiddenEnd& end : junctions.ends) stems[end.bar].push_back(end);
  for (Index bar = 0; bar < lines.size(); ++bar) {
    if (stems[bar].empty()) continue;
    const int side = junctions.sides[bar] != 0 ? junctions.sides[bar] : stems[bar].front().bar_side;
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

void meet_bars(std::vector<CleanLine>& lines, EndTargets& targets, const DrawingScale& scale) {
  std::vector<std::array<std::optional<BarHit>, 2>> hits(lines.size());
  for (Index line = 0; line < targets.size(); ++line) {
    for (const bool at_start : {true, false}) {
      std::optional<EndTarget>& target = targets[line][at_start ? 0 : 1];
      if (!target) continue;
      hits[line][at_start ? 0 : 1] = hit_of(lines, line, at_start, *target, scale.step);
      if (!hits[line][at_start ? 0 : 1]) target.reset();
    }
  }
  for (Index line = 0; line < targets.size(); ++line) {
    for (const bool at_start : {false, true}) {
      const std::optional<BarHit>& hit = hits[line][at_start ? 0 : 1];
      if (!hit) continue;
      if (at_start) reverse(lines[line]);
      move_end(lines[line], *hit, scale.step);
      if (at_start) reverse(lines[line]);
      EndTarget& target = *targets[line][at_start ? 0 : 1];
      target.at = hit->at;
      target.miss = 0;
    }
  }
}

Junctions find_junctions(const Drawing& drawing, const std::vector<CleanLine>& lines, const EndTargets& targets,
                         std::vector<HiddenPiece> pieces, const VisibleCrossings& order, const DrawingScale& scale,
                         const Progress& progress) {
  Junctions junctions;
  junctions.tremble = scale.tremble;
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
  give_pieces(std::move(pieces), lines, scale, junctions);
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
