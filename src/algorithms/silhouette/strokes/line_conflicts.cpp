// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/line_conflicts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) can't be distinguished by eye or by the triangulation that follows.
constexpr double touch_distance = 0.1;
// Crossings flatter than this sine are strokes that run into one another.
constexpr double touch_sine = 0.05;
// Neighbouring segments of one line are near each other by nature.
constexpr Index own_segments = 8;
// A stem is near its bar over this many segments before it ends there.
constexpr double junction_segments = 2;

struct LineMeeting {
  Vec2 at = Vec2::Zero();
  bool crossing = false;
  Index line_a = 0;
  Index line_b = 0;
};

class ConflictSearch {
 public:
  ConflictSearch(const std::vector<CleanLine>& lines, const std::vector<HiddenEnd>& ends, const DrawingScale& scale)
      : lines_(lines), ends_of_(lines.size()), reach_(touch_distance * scale.unit) {
    for (const HiddenEnd& end : ends) ends_of_[end.line].push_back(&end);
  }

  std::optional<LineMeeting> meeting(const GridSegment& a, const GridSegment& b) const {
    const bool same = a.line == b.line;
    const Index apart = same ? separation(a, b) : own_segments + 1;
    if (apart <= 1 || joined(a, b) || joined(b, a)) return std::nullopt;
    if (cross_properly(a.a, a.b, b.a, b.b)) {
      const Vec2 u = a.b - a.a;
      const Vec2 v = b.b - b.a;
      const bool steep = std::abs(cross(u, v)) > touch_sine * u.norm() * v.norm();
      return LineMeeting{a.a + crossing_fraction(a.a, a.b, b.a, b.b) * u, steep, a.line, b.line};
    }
    if (apart <= own_segments) return std::nullopt;
    if (const std::optional<Vec2> at = touch(a, b)) return LineMeeting{*at, false, a.line, b.line};
    return std::nullopt;
  }

 private:
  Index separation(const GridSegment& a, const GridSegment& b) const {
    const Index apart = a.position > b.position ? a.position - b.position : b.position - a.position;
    return lines_[a.line].closed ? std::min(apart, lines_[a.line].segment_count() - apart) : apart;
  }

  /// True where `stem` is the last bit of a line and `bar` the place where that line ends.
  bool joined(const GridSegment& stem, const GridSegment& bar) const {
    for (const HiddenEnd* end : ends_of_[stem.line]) {
      if (end->bar != bar.line) continue;
      const double last = lines_[stem.line].segment_count() - 1.0;
      const double from_end = end->at_start ? stem.position : last - stem.position;
      double from_junction = std::abs(bar.position + 0.5 - end->bar_parameter);
      const double around = lines_[bar.line].segment_count();
      if (lines_[bar.line].closed) from_junction = std::min(from_junction, around - from_junction);
      if (from_end < junction_segments && from_junction < junction_segments + 1) return true;
    }
    return false;
  }

  std::optional<Vec2> touch(const GridSegment& a, const GridSegment& b) const {
    const auto near = [this](const Vec2& point, const GridSegment& s) {
      return (s.a + nearest_parameter(point, s.a, s.b) * (s.b - s.a) - point).norm() < reach_;
    };
    if (near(a.a, b)) return a.a;
    if (near(a.b, b)) return a.b;
    if (near(b.a, a)) return b.a;
    if (near(b.b, a)) return b.b;
    return std::nullopt;
  }

  const std::vector<CleanLine>& lines_;
  std::vector<std::vector<const HiddenEnd*>> ends_of_;
  double reach_;
};

LineFinding describe(const Drawing& drawing, Index s1, Index s2, const LineMeeting& meeting) {
  LineFinding result;
  const std::string both = in_quotes(drawing, s1) + " and " + in_quotes(drawing, s2);
  std::string sentence;
  if (meeting.crossing && s1 == s2) {
    sentence = in_quotes(drawing, s1) +
               " crosses itself in full view: which part is in front? Let the other one stop where it passes behind";
  } else if (meeting.crossing) {
    sentence = both + " cross in full view: which one is in front? Let the other one stop where it passes behind";
  } else if (s1 == s2) {
    sentence = in_quotes(drawing, s1) + " touches itself: draw the two parts apart";
  } else {
    sentence = both + " touch: draw them apart, or let one end at the other";
  }
  std::vector<Subject> subjects{stroke_subject(drawing, s1, meeting.at)};
  if (s1 != s2) subjects.push_back(stroke_subject(drawing, s2, meeting.at));
  subjects.push_back(crossing_subject(drawing, meeting.at));
  result.finding = make_error(Category::Geometry, meeting.crossing ? "E_CROSS" : "E_TOUCH", std::move(sentence),
                              std::move(subjects));
  result.lines = {meeting.line_a};
  if (meeting.line_b != meeting.line_a) result.lines.push_back(meeting.line_b);
  return result;
}

}  // namespace

LineFindings find_line_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                 const std::vector<HiddenEnd>& ends, const VisibleCrossings& order,
                                 const DrawingScale& scale, const Progress& progress) {
  const SegmentGrid grid(line_segments(lines), scale.step, touch_distance * scale.unit);
  const ConflictSearch search(lines, ends, scale);
  std::map<std::pair<Index, Index>, LineMeeting> worst;  // by strokes; a crossing counts as worse than a touch
  std::size_t visited = 0;
  grid.pairs([&](Index i, Index j) {
    constexpr std::size_t pairs_between_checks = 1U << 18U;
    if (++visited % pairs_between_checks == 0) progress.check();
    const GridSegment& a = grid.segments()[i];
    const GridSegment& b = grid.segments()[j];
    if (order.is_known(a.line, b.line)) return;
    const std::optional<LineMeeting> meeting = search.meeting(a, b);
    if (!meeting) return;
    const auto strokes = std::minmax(lines[a.line].stroke[a.position], lines[b.line].stroke[b.position]);
    const auto [place, fresh] = worst.try_emplace({strokes.first, strokes.second}, *meeting);
    if (!fresh && meeting->crossing && !place->second.crossing) place->second = *meeting;
  });
  LineFindings findings;
  for (const auto& [strokes, meeting] : worst) {
    findings.push_back(describe(drawing, strokes.first, strokes.second, meeting));
  }
  return findings;
}

}  // namespace croquis::silhouette
