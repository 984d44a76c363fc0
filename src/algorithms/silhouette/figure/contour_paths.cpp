// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/contour_paths.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace croquis::silhouette {
namespace {

using Drawn = ContourPath::Drawn;

// Samples of a known piece nearer to its bar than so many times what its line goes on behind it give way.
constexpr double clearance = 1.5;

class Closer {
 public:
  Closer(const std::vector<CleanLine>& lines, const Junctions& junctions, const PartLines& part,
         const std::vector<ChosenCompletion>& chosen, double spacing, double stretch)
      : lines_(lines), junctions_(junctions), part_(part), chosen_(chosen), spacing_(spacing), stretch_(stretch) {
    choice_of_.assign(part.ends.size(), no_index);
    for (Index k = 0; k < chosen.size(); ++k) {
      choice_of_[part.candidates[chosen[k].candidate].a] = k;
      choice_of_[part.candidates[chosen[k].candidate].b] = k;
    }
    for (Index e = 0; e < part.ends.size(); ++e) {
      const HiddenEnd& end = junctions.ends[part.ends[e]];
      position_[{end.line, end.at_start}] = e;
    }
  }

  std::optional<ClosedContours> close() {
    for (const Index line : part_.lines) {
      if (done_.count(line) != 0) continue;
      if (!(lines_[line].closed ? add_closed(line) : add_open(line))) return std::nullopt;
    }
    return std::move(result_);
  }

 private:
  bool add_closed(Index line) {
    done_[line] = true;
    ContourPath path;
    path.points = lines_[line].points;
    path.drawn.assign(path.points.size(), Drawn::Yes);
    path.cut.assign(path.points.size(), 0.0);
    path.stroke = lines_[line].stroke;
    path.line.assign(path.points.size(), line);
    path.strokes = lines_[line].strokes;
    path.side = junctions_.sides[line];
    result_.paths.push_back(std::move(path));
    result_.raw.push_back(lines_[line].raw);
    return true;
  }

  /// Follows lines and completions until the first line comes again.
  bool add_open(Index first) {
    ContourPath path;
    Points raw;
    Index line = first;
    bool forward = true;
    do {
      if (done_.count(line) != 0) return false;  // walked in both directions: the sides contradict each other
      done_[line] = true;
      const int side = forward ? junctions_.sides[line] : -junctions_.sides[line];
      if (side != 0 && path.side == -side) return false;
      if (side != 0) path.side = side;
      append_line(line, forward, path, raw);
      const Index leaving = position_.at({line, !forward});
      const Index arriving = append_completion(leaving, path, raw);
      const HiddenEnd& end = junctions_.ends[part_.ends[arriving]];
      line = end.line;
      forward = end.at_start;
    } while (line != first);
    if (!forward) return false;
    drop_repeated(path.strokes);
    result_.paths.push_back(std::move(path));
    result_.raw.push_back(std::move(raw));
    return true;
  }

  /// A stroke that is hidden in between comes as several lines and as what is known between them.
  static void drop_repeated(std::vector<Index>& strokes) {
    std::vector<Index> once;
    for (const Index stroke : strokes) {
      if (std::find(once.begin(), once.end(), stroke) == once.end()) once.push_back(stroke);
    }
    strokes = std::move(once);
  }

  /// Appends the points of a line but its last one, with which the completion begins.
  void append_line(Index index, bool forward, ContourPath& path, Points& raw) {
    const CleanLine& line = lines_[index];
    Points points = line.points;
    std::vector<Index> stroke = line.stroke;
    Points drawn = line.raw;
    std::vector<Index> strokes = line.strokes;
    if (!forward) {
      std::reverse(points.begin(), points.end());
      std::reverse(stroke.begin(), stroke.end());
      std::reverse(drawn.begin(), drawn.end());
      std::reverse(strokes.begin(), strokes.end());
    }
    if (points.size() == 2) {  // the cuts of both ends need a segment each
      points.insert(points.begin() + 1, 0.5 * (points[0] + points[1]));
      drawn.insert(drawn.begin() + 1, 0.5 * (drawn[0] + drawn[1]));
      stroke.insert(stroke.begin() + 1, stroke.front());
    }
    const std::size_t count = points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      path.points.push_back(points[i]);
      path.stroke.push_back(stroke[i]);
      path.line.push_back(index);
      path.drawn.push_back(i == 0 ? Drawn::FromCut : i + 1 == count ? Drawn::UntilCut : Drawn::Yes);
      const bool at_start = i == 0 ? forward : !forward;
      const bool at_end = i == 0 || i + 1 == count;
      path.cut.push_back(at_end ? nearest_parameter(place_of_end(index, at_start), points[i], points[i + 1]) : 0.0);
    }
    path.strokes.insert(path.strokes.end(), strokes.begin(), strokes.end());
    raw.insert(raw.end(), drawn.begin(), drawn.end() - 1);
  }

  Vec2 place_of_end(Index line, bool at_start) const {
    return junctions_.ends[part_.ends[position_.at({line, at_start})]].at;
  }

  /// Appends the completion from an end, without its last point. Returns the end it leads to.
  Index append_completion(Index leaving, ContourPath& path, Points& raw) {
    const Index choice = choice_of_[leaving];
    const CompletionCandidate& candidate = part_.candidates[chosen_[choice].candidate];
    const Index arriving = candidate.a == leaving ? candidate.b : candidate.a;
    HiddenCurve curve = candidate.given != no_index ? given_curve(candidate.given, leaving, arriving)
                                                    : completed_curve(candidate, choice, leaving);
    const auto inner = curve.points.end() - 1;
    path.points.insert(path.points.end(), curve.points.begin(), inner);
    path.stroke.insert(path.stroke.end(), curve.stroke.begin(), curve.stroke.end() - 1);
    path.drawn.insert(path.drawn.end(), curve.points.size() - 1, Drawn::No);
    path.line.insert(path.line.end(), curve.points.size() - 1, no_index);
    path.cut.insert(path.cut.end(), curve.points.size() - 1, 0.0);
    raw.insert(raw.end(), curve.points.begin(), inner);
    if (candidate.given != no_index) {
      path.strokes.insert(path.strokes.end(), curve.stroke.begin(), curve.stroke.end());
    }
    result_.choices.push_back(choice);
    result_.completions.push_back(
        {std::move(curve.points), static_cast<Index>(result_.paths.size()), candidate.cost()});
    return arriving;
  }

  struct HiddenCurve {
    Points points;
    std::vector<Index> stroke;  ///< per point
  };

  HiddenCurve completed_curve(const CompletionCandidate& candidate, Index choice, Index leaving) const {
    std::array<Vec2, 4> curve = candidate.curve;
    if (candidate.b == leaving) std::reverse(curve.begin(), curve.end());
    const std::uint8_t shape = candidate.shapes[chosen_[choice].shape];
    const HiddenEnd& end = junctions_.ends[part_.ends[leaving]];
    const double stretch = choice % 2 == 0 ? stretch_ : -stretch_;
    HiddenCurve result{
        completion_points(curve, completion_shapes[shape], spacing_, lines_[end.bar], end.bar_side, stretch), {}};
    result.stroke.assign(result.points.size(), lines_[end.line].end_stroke(end.at_start));
    return result;
  }

  /// A known piece, between the places behind their bars that the two ends were carried on to.
  HiddenCurve given_curve(Index piece, Index leaving, Index arriving) const {
    const GivenPiece& given = junctions_.given[piece];
    const HiddenEnd& from = junctions_.ends[part_.ends[leaving]];
    const HiddenEnd& to = junctions_.ends[part_.ends[arriving]];
    HiddenCurve all{given.points, given.stroke};
    if (given.from != part_.ends[leaving]) {
      std::reverse(all.points.begin(), all.points.end());
      std::reverse(all.stroke.begin(), all.stroke.end());
    }
    const Vec2& first = lines_[from.line].end(from.at_start);
    const Vec2& last = lines_[to.line].end(to.at_start);
    const double clear_first = clearance * (first - from.at).norm();
    const double clear_last = clearance * (last - to.at).norm();
    HiddenCurve result{{first}, {all.stroke.front()}};
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      if ((all.points[i] - from.at).norm() < clear_first || (all.points[i] - to.at).norm() < clear_last) continue;
      result.points.push_back(all.points[i]);
      result.stroke.push_back(all.stroke[i]);
    }
    if (result.points.size() == 1) {
      result.points.emplace_back(0.5 * (first + last));
      result.stroke.push_back(all.stroke.front());
    }
    result.points.push_back(last);
    result.stroke.push_back(all.stroke.back());
    return result;
  }

  const std::vector<CleanLine>& lines_;
  const Junctions& junctions_;
  const PartLines& part_;
  const std::vector<ChosenCompletion>& chosen_;
  double spacing_;
  double stretch_;
  std::vector<Index> choice_of_;                      ///< per end: index into chosen_
  std::map<std::pair<Index, bool>, Index> position_;  ///< of an end in part_.ends
  std::map<Index, bool> done_;
  ClosedContours result_;
};

}  // namespace

std::optional<ClosedContours> close_contours(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                             const PartLines& part, const std::vector<ChosenCompletion>& chosen,
                                             double spacing, double stretch) {
  return Closer(lines, junctions, part, chosen, spacing, stretch).close();
}

}  // namespace croquis::silhouette
