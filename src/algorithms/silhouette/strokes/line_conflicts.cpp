// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/line_conflicts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) can't be distinguished by eye or by the triangulation that follows.
constexpr double touch_distance = 0.1;
// Crossings flatter than this sine are strokes that run into one another.
constexpr double touch_sine = 0.05;
// Neighbouring segments of one line are near each other by nature.
constexpr double own_segments = 8;
// A stem is near its bar over this many segments before it ends there.
constexpr double junction_segments = 2;

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
    sentence += itself ? " touches itself: draw the two parts apart"
                       : " touch: draw them apart, or let one end at the other";
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

LineFindings find_line_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                 const std::vector<HiddenEnd>& ends, const VisibleCrossings& order,
                                 const DrawingScale& scale, const Progress& progress) {
  const double reach = touch_distance * scale.unit;
  std::map<std::pair<Index, Index>, SegmentContact> worst;  // by strokes; a crossing counts as worse than a touch
  for (const SegmentContact& contact : find_contacts(SegmentGrid(line_segments(lines), scale.step, reach), reach)) {
    progress.check();
    const auto& [a, b] = std::tie(contact.a, contact.b);
    if (order.is_known(a.line, b.line) || is_junction(lines, ends, a, b) || is_junction(lines, ends, b, a)) continue;
    const double apart = a.line == b.line ? separation(lines[a.line], a.position, b.position) : own_segments + 1;
    if (!contact.crosses() && apart <= own_segments) continue;
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

}  // namespace croquis::silhouette
