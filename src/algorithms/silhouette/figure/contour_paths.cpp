// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/contour_paths.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace croquis::silhouette {
namespace {

// Samples of a known piece nearer to its bar than so many times what its line goes on behind it give way.
constexpr double clearance = 1.5;

/// Which completion every end is in.
struct ChosenEnds {
  const FigureContext& context;
  const PartLines& part;
  const std::vector<ChosenCompletion>& chosen;
  std::map<std::pair<Index, bool>, Index> position;  ///< in part.ends: of a line's start (true) and end
  std::vector<Index> choice;                         ///< per position: index into chosen

  const HiddenEnd& end(Index at) const { return context.junctions.ends[part.ends[at]]; }
};

ChosenEnds chosen_ends(const FigureContext& context, const PartLines& part,
                       const std::vector<ChosenCompletion>& chosen) {
  ChosenEnds ends{context, part, chosen, {}, std::vector<Index>(part.ends.size(), no_index)};
  for (Index e = 0; e < part.ends.size(); ++e) ends.position[{ends.end(e).line, ends.end(e).at_start}] = e;
  for (Index k = 0; k < chosen.size(); ++k) {
    ends.choice[part.candidates[chosen[k].candidate].a] = k;
    ends.choice[part.candidates[chosen[k].candidate].b] = k;
  }
  return ends;
}

ContourPath path_of_line(const CleanLine& line, Index index) {
  ContourPath path{line.points, {}, line.raw, line.strokes};
  for (const Index stroke : line.stroke) path.segments.push_back({ContourSegment::Drawn::Yes, stroke, index});
  return path;
}

/// An open line between the bars of its ends, the one that it is entered by first.
ContourPath path_between_bars(const ChosenEnds& ends, Index index, bool forward) {
  ContourPath path = path_of_line(ends.context.lines[index], index);
  if (!forward) {
    std::ranges::reverse(path.points);
    std::ranges::reverse(path.segments);
    std::ranges::reverse(path.raw);
    std::ranges::reverse(path.strokes);
  }
  if (path.points.size() == 2) {  // the cuts of both ends need a segment each
    path.points.insert(path.points.begin() + 1, 0.5 * (path.points[0] + path.points[1]));
    path.raw.insert(path.raw.begin() + 1, 0.5 * (path.raw[0] + path.raw[1]));
    path.segments.insert(path.segments.begin() + 1, path.segments.front());
  }
  const auto cut = [&](std::size_t segment, bool at_start, ContourSegment::Drawn drawn) {
    const Vec2& bar = ends.end(ends.position.at({index, at_start})).at;
    path.segments[segment].drawn = drawn;
    path.segments[segment].cut = nearest_parameter(bar, path.points[segment], path.points[segment + 1]);
  };
  cut(0, forward, ContourSegment::Drawn::FromCut);
  cut(path.points.size() - 2, !forward, ContourSegment::Drawn::UntilCut);
  return path;
}

ContourPath hidden_piece(Points points, const std::vector<Index>& strokes, Index choice) {
  ContourPath piece{points, {}, std::move(points), {}};
  for (const Index stroke : strokes) piece.segments.push_back({ContourSegment::Drawn::No, stroke, no_index, choice});
  return piece;
}

/// The completion from an end on.
ContourPath completed_piece(const ChosenEnds& ends, Index choice, Index leaving) {
  const CompletionCandidate& candidate = ends.part.candidates[ends.chosen[choice].candidate];
  const std::vector<CleanLine>& lines = ends.context.lines;
  Cubic curve = candidate.curve;
  if (candidate.b == leaving) std::ranges::reverse(curve);
  const CompletionShape& shape = completion_shapes[candidate.shapes[ends.chosen[choice].shape]];
  const HiddenEnd& end = ends.end(leaving);
  Points points = completion_points(curve, shape, ends.context.scale.step, lines[end.bar], end.bar_side);
  const std::vector<Index> strokes(points.size(), lines[end.line].end_stroke(end.at_start));
  return hidden_piece(std::move(points), strokes, choice);
}

/// A known piece, between the places behind their bars that the two ends were carried on to.
ContourPath given_piece(const ChosenEnds& ends, const GivenPiece& given, Index choice, Index leaving, Index arriving) {
  const auto carried_on = [&](const HiddenEnd& end) { return ends.context.lines[end.line].end(end.at_start); };
  const auto is_clear = [&](const Vec2& place, const HiddenEnd& end) {
    return (place - end.at).norm() >= clearance * (carried_on(end) - end.at).norm();
  };
  const bool forward = given.from == ends.part.ends[leaving];
  Points points{carried_on(ends.end(leaving))};
  std::vector<Index> strokes{forward ? given.stroke.front() : given.stroke.back()};
  for (std::size_t k = 0; k < given.points.size(); ++k) {
    const std::size_t i = forward ? k : given.points.size() - 1 - k;
    if (!is_clear(given.points[i], ends.end(leaving)) || !is_clear(given.points[i], ends.end(arriving))) continue;
    points.push_back(given.points[i]);
    strokes.push_back(given.stroke[i]);
  }
  points.push_back(carried_on(ends.end(arriving)));
  strokes.push_back(forward ? given.stroke.back() : given.stroke.front());
  ContourPath piece = hidden_piece(std::move(points), strokes, choice);
  piece.strokes = std::move(strokes);
  return piece;
}

/// Appends a piece but its last point, with which the next one begins. A stroke that is hidden in between comes as
/// several lines and as what is known between them.
void append_piece(const ContourPath& piece, ContourPath& path) {
  path.points.insert(path.points.end(), piece.points.begin(), piece.points.end() - 1);
  path.segments.insert(path.segments.end(), piece.segments.begin(), piece.segments.end() - 1);
  path.raw.insert(path.raw.end(), piece.raw.begin(), piece.raw.end() - 1);
  for (const Index stroke : piece.strokes) {
    if (std::ranges::find(path.strokes, stroke) == path.strokes.end()) path.strokes.push_back(stroke);
  }
}

/// Appends the completion from an end. Returns the end it leads to.
Index append_completion(const ChosenEnds& ends, Index leaving, ContourPath& path, ClosedContours& result) {
  const Index choice = ends.choice[leaving];
  const CompletionCandidate& candidate = ends.part.candidates[ends.chosen[choice].candidate];
  const Index arriving = candidate.a == leaving ? candidate.b : candidate.a;
  ContourPath piece = candidate.given == no_index
                          ? completed_piece(ends, choice, leaving)
                          : given_piece(ends, ends.context.junctions.given[candidate.given], choice, leaving, arriving);
  append_piece(piece, path);
  result.completions.push_back({std::move(piece.points), static_cast<Index>(result.paths.size()), candidate.cost()});
  return arriving;
}

/// Follows lines and completions until the first line comes again.
bool add_open_lines(const ChosenEnds& ends, Index first, std::vector<char>& done, ClosedContours& result) {
  ContourPath path;
  Index line = first;
  bool forward = true;
  do {
    if (done[line]) return false;  // walked in both directions: the sides contradict each other
    done[line] = 1;
    const int side = (forward ? 1 : -1) * ends.context.junctions.sides[line];
    if (side != 0 && path.side == -side) return false;
    if (side != 0) path.side = side;
    append_piece(path_between_bars(ends, line, forward), path);
    const HiddenEnd& end = ends.end(append_completion(ends, ends.position.at({line, !forward}), path, result));
    line = end.line;
    forward = end.at_start;
  } while (line != first);
  result.paths.push_back(std::move(path));
  return forward;
}

}  // namespace

std::optional<ClosedContours> close_contours(const FigureContext& context, const PartLines& part,
                                             const std::vector<ChosenCompletion>& chosen) {
  const ChosenEnds ends = chosen_ends(context, part, chosen);
  ClosedContours result;
  std::vector<char> done(context.lines.size(), 0);
  for (const Index line : part.lines) {
    if (context.lines[line].closed) {
      result.paths.push_back(path_of_line(context.lines[line], line));
      result.paths.back().side = context.junctions.sides[line];
    } else if (!done[line] && !add_open_lines(ends, line, done, result)) {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace croquis::silhouette
