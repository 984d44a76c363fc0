// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/line_cutting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// The strokes as drawn run along the samples: a place on them is looked for within this share of their length.
constexpr double raw_window = 0.1;

class Cutter {
 public:
  Cutter(const CleanLine& line, double spacing)
      : line_(line), spacing_(spacing), raw_arcs_(arc_lengths(line.raw, line.closed)) {}

  /// Samples from one parameter to another, which may run on past the first point of a closed line.
  void sample(const LineRun& run, Points& points, std::vector<Index>& stroke) const {
    const auto add = [&](double parameter, const Vec2& at) {
      points.push_back(at);
      stroke.push_back(line_.stroke[static_cast<std::size_t>(wrapped(parameter)) % line_.stroke.size()]);
    };
    const Vec2 first = place(run.begin);
    const Vec2 last = place(run.end);
    add(run.begin, first);
    for (double i = std::floor(run.begin) + 1; i < run.end; ++i) {
      const Vec2 at = place(i);
      if ((at - first).norm() >= spacing_ && (at - last).norm() >= spacing_) add(i, at);
    }
    add(run.end, last);
    // A line of one segment has no middle to be told apart from its ends.
    if (points.size() == 2) {
      points.insert(points.begin() + 1, place(0.5 * (run.begin + run.end)));
      stroke.insert(stroke.begin() + 1, stroke.front());
    }
  }

  CleanLine piece(const LineRun& run) const {
    CleanLine result;
    result.object = line_.object;
    result.size = line_.size;
    sample(run, result.points, result.stroke);
    for (const Index stroke : result.stroke) {
      if (std::find(result.strokes.begin(), result.strokes.end(), stroke) == result.strokes.end()) {
        result.strokes.push_back(stroke);
      }
    }
    result.raw = raw_between(run);
    return result;
  }

 private:
  double wrapped(double parameter) const {
    const double count = line_.segment_count();
    if (!line_.closed) return parameter;
    const double turned = parameter - count * std::floor(parameter / count);
    return turned < count ? turned : 0;
  }

  Vec2 place(double parameter) const { return point_at(line_.points, wrapped(parameter)); }

  /// Arc length on the strokes as drawn of the place nearest to a parameter's, counted on round closed lines.
  double raw_arc(double parameter) const {
    const Vec2 at = place(parameter);
    const double length = raw_arcs_.back();
    const double turns = line_.closed ? std::floor(parameter / line_.segment_count()) : 0;
    const double expected = wrapped(parameter) / line_.segment_count() * length;
    double best = std::numeric_limits<double>::infinity();
    double found = expected;
    for (std::size_t i = 0; i + 1 < raw_arcs_.size(); ++i) {
      const Vec2& a = line_.raw[i];
      const Vec2& b = line_.raw[(i + 1) % line_.raw.size()];
      const double fraction = nearest_parameter(at, a, b);
      const double arc = raw_arcs_[i] + fraction * (raw_arcs_[i + 1] - raw_arcs_[i]);
      double aside = std::abs(arc - expected);
      if (line_.closed) aside = std::min(aside, length - aside);
      if (aside > raw_window * length) continue;
      const double distance = (a + fraction * (b - a) - at).norm();
      if (distance < best) {
        best = distance;
        found = arc;
      }
    }
    // Near the first point the place found may lie on the other side of it.
    if (line_.closed && found - expected > length / 2) found -= length;
    if (line_.closed && expected - found > length / 2) found += length;
    return found + turns * length;
  }

  Points raw_between(const LineRun& run) const {
    const double begin = raw_arc(run.begin);
    const double end = raw_arc(run.end);
    const double length = raw_arcs_.back();
    Points points{place(run.begin)};
    const auto count = static_cast<std::ptrdiff_t>(line_.raw.size());
    for (const double turn :
         line_.closed ? std::vector<double>{-length, 0, length, 2 * length} : std::vector<double>{0}) {
      for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double arc = raw_arcs_[static_cast<std::size_t>(i)] + turn;
        if (arc > begin && arc < end) points.push_back(line_.raw[static_cast<std::size_t>(i)]);
      }
    }
    points.push_back(place(run.end));
    return points;
  }

  const CleanLine& line_;
  double spacing_;
  std::vector<double> raw_arcs_;
};

}  // namespace

void append_cut(const CleanLine& line, const std::vector<CutRun>& cuts, double spacing, std::vector<CleanLine>& lines,
                std::vector<HiddenPiece>& pieces) {
  if (cuts.empty()) {
    lines.push_back(line);
    return;
  }
  const Cutter cutter(line, spacing);
  const double last = line.segment_count();
  const auto first_line = static_cast<Index>(lines.size());
  const bool starts_covered = !line.closed && cuts.front().run.begin <= 0;
  const bool ends_covered = !line.closed && cuts.back().run.end >= last;
  if (!line.closed && !starts_covered) lines.push_back(cutter.piece({0, cuts.front().run.begin}));
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const bool is_last = k + 1 == cuts.size();
    if (is_last && ends_covered) break;
    const double on = is_last ? (line.closed ? cuts.front().run.begin + last : last) : cuts[k + 1].run.begin;
    lines.push_back(cutter.piece({cuts[k].run.end, on}));
  }
  // The pieces of a closed line follow one another: the first cut lies between the last piece and the first.
  const auto count = static_cast<Index>(lines.size()) - first_line;
  for (Index k = 0; k < cuts.size(); ++k) {
    if ((k == 0 && starts_covered) || (k + 1 == cuts.size() && ends_covered)) continue;
    const Index before = line.closed ? (k + count - 1) % count : starts_covered ? k - 1 : k;
    const Index after = line.closed ? k : before + 1;
    HiddenPiece piece;
    piece.from = {first_line + before, false, cuts[k].begin_side};
    piece.to = {first_line + after, true, cuts[k].end_side};
    cutter.sample(cuts[k].run, piece.points, piece.stroke);
    pieces.push_back(std::move(piece));
  }
}

}  // namespace croquis::silhouette
