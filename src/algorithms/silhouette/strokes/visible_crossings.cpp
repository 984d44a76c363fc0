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
#include "algorithms/silhouette/strokes/line_cutting.h"
#include "algorithms/silhouette/strokes/segment_grid.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// Lines that come no further than this (u) beyond one another touch: crossings as shallow as that are a hand's tremble.
constexpr double crossing_tremble = 2;
// And as deep as this share of the smaller one's size where the hand was as unsteady as can be.
constexpr double unsteady_share = 0.05;
// Closed lines that come nearer than this (u) are moved apart.
constexpr double touching = 0.2;
// No sample lies nearer to the end of a cut line than this share of a step.
constexpr double least_cut_spacing = 0.3;

/// A line that another one covers, and by which pair of strokes that is told.
struct Cover {
  Index front = 0;
  bool chosen = false;
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
    VisibleCrossings result;
    std::vector<CleanLine> cut;
    for (const std::vector<CutRun>& cuts : all_cuts(progress)) {
      append_cut(lines_[static_cast<Index>(&cuts - cuts_.data())], cuts, least_cut_spacing * scale_.step, cut,
                 result.pieces);
    }
    lines_ = std::move(cut);
    result.pairs = std::move(told_);
    for (const CrossingInView& pair : result.pairs) {
      if (!pair.tube) result.findings.push_back(warning(pair));
    }
    return result;
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
    if (tubes_only_ && !lines_[a].tube && !lines_[b].tube) return;
    if (!lines_[a].closed && !lines_[b].closed) return;
    if (lines_[a].closed != lines_[b].closed) {
      const Index open = lines_[a].closed ? b : a;
      covers_[open].push_back({open == a ? b : a, false});
      return;
    }
    const Index front = front_of(ring_of(a), ring_of(b)) == ring_of(a) ? a : b;
    const Index behind = front == a ? b : a;
    // What lies in the hole of the ring in front is seen.
    if (ring_of(front) == front) covers_[behind].push_back({front, told_apart(front, ring_of(behind))});
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

  /// What is covered of every line. Lines are moved where they nearly touch, those in front first.
  const std::vector<std::vector<CutRun>>& all_cuts(const Progress& progress) {
    cuts_.resize(lines_.size());
    std::vector<Index> order(lines_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [this](Index a, Index b) { return last_stroke(a) > last_stroke(b); });
    for (const Index line : order) {
      progress.check();
      std::vector<CutRun> runs;
      for (const Cover& cover : covers_[line]) {
        const std::vector<CutRun> covered = covered_by(line, cover.front);
        runs.insert(runs.end(), covered.begin(), covered.end());
        if (covered.empty()) continue;
        const double at =
            covered.front().run.begin > 0 || lines_[line].closed ? covered.front().run.begin : covered.front().run.end;
        tell(line, cover, at);
      }
      cuts_[line] = joined(line, std::move(runs));
    }
    std::sort(told_.begin(), told_.end(), [](const CrossingInView& a, const CrossingInView& b) {
      return std::pair(a.front, a.behind) < std::pair(b.front, b.behind);
    });
    return cuts_;
  }

  /// How far two lines may come beyond one another without being meant to cross.
  double tremble_between(const CleanLine& a, const CleanLine& b) const {
    if (a.tube || b.tube) return 0;  // a limb's round end may cover little
    return std::max(crossing_tremble * scale_.unit, unsteady_share * scale_.tremble * std::min(a.size, b.size));
  }

  /// The stretches of a line that one in front covers, holes of it left out.
  std::vector<CutRun> covered_by(Index line, Index front) {
    const double tremble = tremble_between(lines_[line], lines_[front]);
    const int side = signed_area(lines_[front].points) > 0 ? 1 : -1;
    std::vector<CutRun> covered;
    for (const LineRun& run : covered_runs(lines_[line], lines_[front], tremble, scale_.step)) {
      covered.push_back({run, side, side});
    }
    for (Index hole = 0; hole < lines_.size(); ++hole) {
      if (ring_of_[hole] != front) continue;
      const double beside = tremble_between(lines_[line], lines_[hole]);
      const std::vector<LineRun> seen =
          repeated(covered_runs(lines_[line], lines_[hole], beside, scale_.step), lines_[line]);
      covered = covered_by_ring(covered, seen, signed_area(lines_[hole].points) > 0 ? -1 : 1);
    }
    return covered;
  }

  /// Stretches of a closed line once more a turn before and after: others may run past its first point.
  static std::vector<LineRun> repeated(std::vector<LineRun> runs, const CleanLine& line) {
    const std::size_t once = runs.size();
    const double count = line.segment_count();
    for (std::size_t i = 0; line.closed && i < once; ++i) {
      runs.push_back({runs[i].begin - count, runs[i].end - count});
      runs.push_back({runs[i].begin + count, runs[i].end + count});
    }
    return runs;
  }

  void tell(Index line, const Cover& cover, double parameter) {
    const double count = lines_[line].segment_count();
    const double turned = lines_[line].closed ? parameter - count * std::floor(parameter / count) : parameter;
    told_.push_back({last_stroke(cover.front), last_stroke(line),
                     point_at(lines_[line].points, std::min(turned, count)), cover.chosen,
                     lines_[line].closed && lines_[cover.front].closed && !lines_[cover.front].bridged,
                     lines_[line].tube || lines_[cover.front].tube});
  }

  /// The union of covered runs. None for a line that is covered completely.
  std::vector<CutRun> joined(Index line, std::vector<CutRun> runs) const {
    if (runs.empty()) return runs;
    const double count = lines_[line].segment_count();
    if (lines_[line].closed) {
      const std::optional<double> free = uncovered(runs, count);
      if (!free) return {};
      for (CutRun& cut : runs) {
        const double turns = std::floor((cut.run.begin - *free) / count);
        cut.run.begin -= turns * count;
        cut.run.end -= turns * count;
      }
    }
    std::sort(runs.begin(), runs.end(), [](const CutRun& a, const CutRun& b) {
      return std::pair(a.run.begin, a.run.end) < std::pair(b.run.begin, b.run.end);
    });
    std::vector<CutRun> result;
    for (const CutRun& cut : runs) {
      if (result.empty() || cut.run.begin > result.back().run.end) {
        result.push_back(cut);
      } else if (cut.run.end > result.back().run.end) {
        result.back().run.end = cut.run.end;
        result.back().end_side = cut.end_side;
      }
    }
    const bool whole = !lines_[line].closed && result.front().run.begin <= 0 && result.front().run.end >= count;
    return whole ? std::vector<CutRun>{} : result;
  }

  /// The end of a run that no other run covers.
  static std::optional<double> uncovered(const std::vector<CutRun>& runs, double count) {
    for (const CutRun& candidate : runs) {
      const double place = candidate.run.end;
      const bool covered = std::any_of(runs.begin(), runs.end(), [&](const CutRun& other) {
        const double from = place - other.run.begin;
        const double turned = from - count * std::floor(from / count);
        return &other != &candidate && turned < other.run.end - other.run.begin;
      });
      if (!covered) return place;
    }
    return std::nullopt;
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
  std::vector<std::vector<CutRun>> cuts_;   ///< per line
  std::vector<Index> ring_of_;              ///< per line, see holes_of_rings
  std::vector<CrossingInView> told_;
};

}  // namespace

VisibleCrossings cut_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines, const DrawingScale& scale,
                                       bool tubes_only, const Progress& progress) {
  return CrossingReader(drawing, lines, scale, tubes_only).run(progress);
}

}  // namespace croquis::silhouette
