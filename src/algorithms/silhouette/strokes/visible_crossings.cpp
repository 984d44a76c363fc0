// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/visible_crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/strokes/covered_runs.h"
#include "algorithms/silhouette/strokes/crossed_rings.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// Closed lines that come nearer than this (u) are moved apart.
constexpr double touching = 0.2;

/// A line in front of another one.
struct Cover {
  Index front = 0;
  bool chosen = false;   ///< told by the strokes
  bool is_hole = false;  ///< of a ring, which is told of by itself
};

class CrossingReader {
 public:
  CrossingReader(const Drawing& drawing, std::vector<CleanLine>& lines, const DrawingScale& scale, bool tubes_only)
      : drawing_(drawing), lines_(lines), scale_(scale), tubes_only_(tubes_only) {}

  VisibleCrossings run(const Progress& progress) {
    const std::set<std::pair<Index, Index>> pairs = crossing_pairs();
    if (pairs.empty()) return {};
    covers_.resize(lines_.size());
    ring_of_ = holes_of_rings(drawing_, lines_, pairs);
    for (const auto& [a, b] : pairs) read_pair(a, b);
    result_.sides.assign(lines_.size(), 0);
    order_lines(progress);
    std::ranges::sort(result_.pairs, {}, [](const CrossingInView& pair) { return std::pair(pair.front, pair.behind); });
    for (const CrossingInView& pair : result_.pairs) {
      if (!pair.grown) result_.findings.push_back(warning(pair));
    }
    return std::move(result_);
  }

 private:
  /// Pairs of lines that cross, and of closed ones that touch.
  std::set<std::pair<Index, Index>> crossing_pairs() const {
    const double reach = touching * scale_.unit;
    const SegmentGrid grid(line_segments(lines_), scale_.step, reach);
    std::set<std::pair<Index, Index>> found;
    grid.pairs([&](Index i, Index j) {
      const GridSegment& a = grid.segments()[i];
      const GridSegment& b = grid.segments()[j];
      if (a.line == b.line) return;
      const auto near = [reach](const Vec2& point, const GridSegment& s) {
        return (s.a + nearest_parameter(point, s.a, s.b) * (s.b - s.a) - point).norm() < reach;
      };
      const bool touch = lines_[a.line].closed && lines_[b.line].closed && (near(a.a, b) || near(b.a, a));
      if (touch || cross_properly(a.a, a.b, b.a, b.b)) found.insert(std::minmax(a.line, b.line));
    });
    return found;
  }

  Index last_stroke(Index line) const {
    return *std::max_element(lines_[line].strokes.begin(), lines_[line].strokes.end());
  }

  bool told_behind_line(Index line, Index other) const {
    const auto told = [&](Index s) {
      return std::any_of(lines_[other].strokes.begin(), lines_[other].strokes.end(),
                         [&](Index t) { return told_behind(drawing_.strokes[s], drawing_.strokes[t]); });
    };
    return std::any_of(lines_[line].strokes.begin(), lines_[line].strokes.end(), told);
  }

  void read_pair(Index a, Index b) {
    if (tubes_only_ && !lines_[a].grows() && !lines_[b].grows()) return;
    if (!lines_[a].closed && !lines_[b].closed) return;
    if (lines_[a].closed != lines_[b].closed) {
      const Index open = lines_[a].closed ? b : a;
      covers_[open].push_back({open == a ? b : a, false, false});
      return;
    }
    const Index front = front_of(ring_of(a), ring_of(b)) == ring_of(a) ? a : b;
    const Index behind = front == a ? b : a;
    covers_[behind].push_back({front, told_apart(ring_of(front), ring_of(behind)), ring_of(front) != front});
  }

  /// The line itself, or the one around it that it is a hole of.
  Index ring_of(Index line) const { return ring_of_[line] == no_index ? line : ring_of_[line]; }

  bool told_apart(Index a, Index b) const { return told_behind_line(a, b) || told_behind_line(b, a); }

  /// The ends of an outline that was left open are seen within what it lies in front of.
  bool opens_within(Index line, Index other) const {
    const Points& points = lines_[line].points;
    return lines_[line].bridged && encloses(lines_[other], (points.front() + points.back()) / 2);
  }

  Index front_of(Index a, Index b) const {
    const Index later = last_stroke(a) > last_stroke(b) ? a : b;
    const Index earlier = later == a ? b : a;
    if (told_behind_line(later, earlier)) return earlier;
    return opens_within(earlier, later) && !opens_within(later, earlier) ? earlier : later;
  }

  /// Lines are moved where they nearly touch, those in front first; what crosses then was meant to.
  void order_lines(const Progress& progress) {
    std::vector<Index> order(lines_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [this](Index a, Index b) { return last_stroke(a) > last_stroke(b); });
    for (const Index line : order) {
      progress.check();
      for (const Cover& cover : covers_[line]) {
        const double tremble = tremble_between(lines_[line], lines_[cover.front]);
        const std::vector<LineRun> runs = covered_runs(lines_[line], lines_[cover.front], tremble, scale_.step);
        if (runs.empty()) continue;
        result_.in_front.emplace(cover.front, line);
        result_.behind.insert(line);
        const int inside = signed_area(lines_[cover.front].points) > 0 ? 1 : -1;
        result_.sides[cover.front] = cover.is_hole ? -inside : inside;
        const bool starts_covered = !lines_[line].closed && runs.front().begin <= 0;
        if (!cover.is_hole) tell(line, cover, starts_covered ? runs.front().end : runs.front().begin);
      }
    }
  }

  /// How far two lines may come beyond one another without being meant to cross.
  double tremble_between(const CleanLine& a, const CleanLine& b) const {
    if (a.grows() || b.grows()) return 0;  // a limb's round end may cover little
    return scale_.shallow(std::min(a.size, b.size));
  }

  void tell(Index line, const Cover& cover, double parameter) {
    const double count = lines_[line].segment_count();
    const double turned = lines_[line].closed ? parameter - count * std::floor(parameter / count) : parameter;
    result_.pairs.push_back({last_stroke(cover.front), last_stroke(line),
                             point_at(lines_[line].points, std::min(turned, count)), cover.chosen,
                             lines_[line].closed && lines_[cover.front].closed && !lines_[cover.front].bridged,
                             lines_[line].grows() || lines_[cover.front].grows()});
  }

  Finding warning(const CrossingInView& pair) const {
    const std::string front = in_quotes(drawing_, pair.front);
    const std::string behind = in_quotes(drawing_, pair.behind);
    const std::string why = pair.chosen ? "as it is told" : "if it lies behind, let it stop at the other one";
    return make_warning(
        Category::Geometry, "W_CROSS",
        front + " and " + behind + " cross in full view: " + front + " is read as the one in front; " + why,
        {stroke_subject(drawing_, pair.front, pair.at), stroke_subject(drawing_, pair.behind, pair.at),
         crossing_subject(drawing_, pair.at)});
  }

  const Drawing& drawing_;
  std::vector<CleanLine>& lines_;
  const DrawingScale& scale_;
  bool tubes_only_;
  std::vector<std::vector<Cover>> covers_;  ///< per line
  std::vector<Index> ring_of_;              ///< per line, see holes_of_rings
  VisibleCrossings result_;
};

}  // namespace

VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress) {
  return CrossingReader(drawing, lines, scale, tubes_only).run(progress);
}

}  // namespace croquis::silhouette
