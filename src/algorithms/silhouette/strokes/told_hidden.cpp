// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/told_hidden.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// A hidden stroke begins no farther from the end that it goes on from than this share of its own length, or the gap
// that is closed between visible strokes.
constexpr double farthest_share = 0.15;

using End = HiddenPiece::End;

class Teller {
 public:
  Teller(const Drawing& drawing, const std::vector<CleanLine>& lines, const DrawingScale& scale)
      : drawing_(drawing), lines_(lines), scale_(scale) {}

  void read(const HiddenStroke& stroke) {
    const Vec2& first = stroke.points.front();
    const Vec2& last = stroke.points.back();
    if (stroke.closed) {
      add_fault(stroke, "is closed: draw it from where a line passes behind something to where it comes out", first);
      return;
    }
    const double length = croquis::length(stroke.points, false);
    const double farthest = std::max(scale_.gap, farthest_share * length);
    const std::optional<End> from = nearest_end(first, farthest, std::nullopt);
    const std::optional<End> to = nearest_end(last, farthest, from);
    if (!from || !to) {
      add_fault(stroke, "begins or ends where no line does that it could go on from: draw it up to one",
                from ? last : first);
      return;
    }
    taken_.insert({from->line, from->at_start});
    taken_.insert({to->line, to->at_start});
    Points points = moved(stroke.points, place_of(*from), place_of(*to), std::min(scale_.step, length / 4));
    std::vector<Index> strokes(points.size(), stroke.stroke);
    result_.pieces.push_back({*from, *to, std::move(points), std::move(strokes)});
  }

  ToldHidden take() { return std::move(result_); }

 private:
  const Vec2& place_of(const End& end) const { return lines_[end.line].end(end.at_start); }

  void add_fault(const HiddenStroke& stroke, const std::string& fault, const Vec2& at) {
    result_.findings.push_back({make_error(Category::Geometry, "E_HIDDEN_STROKE",
                                           "The hidden stroke " + in_quotes(drawing_, stroke.stroke) + " " + fault,
                                           {stroke_subject(drawing_, stroke.stroke, at)}),
                                {}});
  }

  /// The end of a line that is nearest to a place, and that no other stroke goes on from.
  std::optional<End> nearest_end(const Vec2& place, double farthest, const std::optional<End>& other) const {
    std::optional<End> found;
    for (Index line = 0; line < lines_.size(); ++line) {
      if (lines_[line].closed) continue;
      for (const bool at_start : {true, false}) {
        const double distance = (lines_[line].end(at_start) - place).norm();
        const bool is_other = other && other->line == line && other->at_start == at_start;
        if (distance > farthest || is_other || taken_.contains({line, at_start})) continue;
        farthest = distance;
        found = End{line, at_start};
      }
    }
    return found;
  }

  /// A line sampled evenly and moved so that its ends are where they belong.
  static Points moved(const Points& drawn, const Vec2& from, const Vec2& to, double spacing) {
    Points points;
    for (const double parameter : even_parameters(drawn, false, spacing)) points.push_back(point_at(drawn, parameter));
    const Vec2 at_first = from - points.front();
    const Vec2 at_last = to - points.back();
    const auto last = static_cast<double>(points.size() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = static_cast<double>(i) / last;
      points[i] += (1 - share) * at_first + share * at_last;
    }
    return points;
  }

  const Drawing& drawing_;
  const std::vector<CleanLine>& lines_;
  const DrawingScale& scale_;
  std::set<std::pair<Index, bool>> taken_;
  ToldHidden result_;
};

}  // namespace

ToldHidden told_hidden(const Drawing& drawing, const std::vector<HiddenStroke>& hidden,
                       const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  Teller teller(drawing, lines, scale);
  for (const HiddenStroke& stroke : hidden) teller.read(stroke);
  return teller.take();
}

}  // namespace croquis::silhouette
