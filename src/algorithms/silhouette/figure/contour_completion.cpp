// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/contour_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <span>
#include <utility>

#include "algorithms/silhouette/figure/hidden_strips.h"
#include "algorithms/silhouette/reading/reading_costs.h"
#include "algorithms/silhouette/strokes/covered_runs.h"

namespace croquis::silhouette {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
// Midpoint rule over so many pieces: the bending of a half circle is right to 0.1 %.
constexpr int integration_pieces = 24;
// A cap turns round by at most so much: half a turn for a limb's end, more where the line is mostly hidden.
constexpr double most_cap_turn = 1.6 * std::numbers::pi;
// Directions at the ends are known so well, all in all.
constexpr double turn_tolerance = 1;
// What covers a piece is asked of so many chords.
constexpr int judged_pieces = 20;

double turning_of(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 before = points[i] - points[i - 1];
    const Vec2 after = points[i + 1] - points[i];
    sum += std::atan2(cross(before, after), before.dot(after));
  }
  return sum;
}

/// Two lines from one thing, of which one goes round the other, are the two sides of a handle.
void find_handles(const std::vector<CleanLine>& lines, std::vector<SeenEnd>& ends) {
  const auto bars = [](const SeenEnd& end) { return std::minmax(end.bar, end.other->bar); };
  const auto is_free = [](const SeenEnd& end) { return end.other != nullptr && end.side == 0; };
  for (SeenEnd& inner : ends | std::views::filter(is_free)) {
    const Points& points = lines[inner.line].points;
    for (SeenEnd& outer : ends | std::views::filter(is_free)) {
      if (inner.line == outer.line || bars(inner) != bars(outer)) continue;
      if (!encloses(lines[outer.line], points[points.size() / 2])) continue;
      inner.handle = -1;
      outer.handle = 1;
    }
  }
}

/// @param positions of the ends among those of the junctions, ascending
std::vector<SeenEnd> seen_ends(const std::vector<CleanLine>& lines, const Junctions& junctions,
                               const std::vector<Index>& positions) {
  std::vector<SeenEnd> ends;
  for (const Index position : positions) {
    SeenEnd end{junctions.ends[position]};
    const Points& points = lines[end.line].points;
    const int outward = end.at_start ? -1 : 1;
    end.place = lines[end.line].end(end.at_start);
    end.side = outward * junctions.sides[end.line];
    end.roundness = std::max(0.0, 1 - 2 * (points.back() - points.front()).norm() / length(points, false));
    end.turning = outward * turning_of(points);
    ends.push_back(end);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {  // those of one line are neighbours
    if (ends[i].line != ends[i + 1].line) continue;
    ends[i].other = &ends[i + 1];
    ends[i + 1].other = &ends[i];
  }
  find_handles(lines, ends);
  for (SeenEnd& end : ends) {
    const bool left = (signed_area(lines[end.line].points) >= 0) == (end.handle >= 0);
    end.likely_side = end.side != 0 ? end.side : left == end.at_start ? -1 : 1;
  }
  return ends;
}

/// Whether the outline through a, along the curve and back along the line of b closes a limb: it goes round once, with
/// its surface inside as far as that is known, and its caps only turn the way that all of it does. A limb is one line
/// (an ear), or two lines between the same two things (a neck).
bool turns_once(const SeenEnd& a, const SeenEnd& b, const Cubic& curve) {
  // A curve without inflection of its handles turns like its control polygon.
  std::vector<double> caps{turning_of(curve)};
  double whole = a.turning + caps[0];
  if (a.line != b.line) {
    // What other lines end at is more likely a strand that goes on than a limb.
    if (a.side != 0 || b.side != 0 || a.other == nullptr || b.other == nullptr) return false;
    if (a.bar != b.bar || a.other->bar != b.other->bar || a.bar == a.other->bar) return false;
    caps.push_back(turning_of(completion_curve(b.other->place, b.other->tangent, a.other->place, a.other->tangent)));
    whole += caps[1] - b.turning;
  }
  const int sense = whole > 0 ? 1 : -1;
  return std::abs(sense * whole - 2 * std::numbers::pi) < turn_tolerance && whole * a.side >= 0 &&
         std::ranges::all_of(caps, [&](double cap) { return sense * cap >= 0 && sense * cap <= most_cap_turn; });
}

/// What a piece costs at most, since it closes a limb.
double highest_cost(const SeenEnd& a, const SeenEnd& b, const Cubic& curve, double tremble) {
  if (a.line != b.line) {
    // How far curves turn says little of an unsteady hand's lines: strands of knots would be closed as necks.
    return tremble < 1 && turns_once(a, b, curve) ? costs::limb_cap / (1 - tremble) : no_limit;
  }
  // A line that passes behind itself goes on there, and the two sides of a handle belong together.
  if (a.bar == a.line || b.bar == b.line || a.handle != 0) return no_limit;
  return turns_once(a, b, curve) ? costs::limb_cap : no_limit;
}

/// The known piece that an end belongs to.
Index given_piece_of(const Junctions& junctions, Index end) {
  const auto piece = std::ranges::find_if(
      junctions.given, [&](const GivenPiece& known) { return known.from == end || known.to == end; });
  return piece == junctions.given.end() ? no_index : static_cast<Index>(piece - junctions.given.begin());
}

bool may_join(const std::vector<CleanLine>& lines, const SeenEnd& a, const SeenEnd& b) {
  const std::string& first = lines[a.line].object;
  const std::string& second = lines[b.line].object;
  return (first.empty() || second.empty() || first == second) && a.side * b.side <= 0;
}

/// Gives a candidate its curve, and the costs that what is seen of both lines tells.
void judge_shape(const SeenEnd& a, const SeenEnd& b, double tremble, double reference, const CompletionOptions& options,
                 CompletionCandidate& candidate) {
  const int agreed = a.likely_side == -b.likely_side ? a.likely_side : 0;
  candidate.curve = completion_curve(a.place, a.tangent, b.place, b.tangent);
  candidate.shape_cost = completion_cost(candidate.curve, agreed, reference, options);
  if (agreed == 0) candidate.opposition = costs::opposite_sides * std::min(a.roundness, b.roundness);
  candidate.most = highest_cost(a, b, candidate.curve, tremble);
}

/// Brings the shapes that keep a candidate covered to the front, and makes it dearer when there is none.
void judge_cover(const DrawnCover& cover, bool one_bar, CompletionCandidate& candidate) {
  std::array<double, completion_shapes.size()> open{};
  for (const std::uint8_t shape : candidate.shapes) {
    const Points chords = completion_chords(candidate.curve, completion_shapes[shape], judged_pieces);
    open[shape] = costs::in_the_open * cover.missing(chords);
    if (shape == 0 && open[shape] <= 0) return;
  }
  std::ranges::stable_sort(candidate.shapes, {}, [&](std::uint8_t shape) { return open[shape]; });
  candidate.open = open[candidate.shapes.front()];
  if (candidate.open > 0 && one_bar) candidate.shapes.insert(candidate.shapes.begin(), kept_behind_shape);
}

double first_step(const CleanLine& line) { return (line.points[1] - line.points[0]).norm(); }

}  // namespace

double CompletionCandidate::cost() const {
  const double alone = std::min(shape_cost + opposition, most) + open;
  return strip < 1 ? std::min(strip * alone, costs::strip_side) : strip * alone;
}

double completion_cost(const Cubic& p, int side, double reference, const CompletionOptions& options) {
  double length = 0;
  double bending = 0;
  for (int i = 0; i < integration_pieces; ++i) {
    const double t = (i + 0.5) / integration_pieces;
    const double s = 1 - t;
    const Vec2 first = 3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
    const Vec2 second = 6 * (s * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]));
    const double speed = first.norm();
    if (!(speed > 0)) return no_limit;
    length += speed / integration_pieces;
    const double turn = cross(first, second);
    const double factor = turn * side < 0 ? costs::bent_away : 1;
    bending += factor * turn * turn / (speed * speed * speed * speed * speed) / integration_pieces;
  }
  return options.length_weight * length / reference + options.curvature_weight * (p[3] - p[0]).norm() * bending;
}

double completion_reference(const std::vector<CleanLine>& lines, const Junctions& junctions) {
  std::vector<Vec2> places;
  for (Index e = 0; e < junctions.ends.size(); ++e) {
    const HiddenEnd& end = junctions.ends[e];
    if (given_piece_of(junctions, e) == no_index) places.push_back(lines[end.line].end(end.at_start));
  }
  if (places.empty()) return 0;
  std::vector<double> nearest;
  for (const Vec2& place : places) {
    nearest.push_back(no_limit);
    for (const Vec2& other : places) {
      if (&other != &place) nearest.back() = std::min(nearest.back(), (other - place).norm());
    }
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

std::vector<CompletionCandidate> completion_candidates(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                                       const std::vector<Index>& ends, double reference,
                                                       const CompletionOptions& options) {
  const std::vector<SeenEnd> seen = seen_ends(lines, junctions, ends);
  std::vector<Index> given;
  for (const Index end : ends) given.push_back(given_piece_of(junctions, end));
  std::vector<CompletionCandidate> candidates;
  for (Index i = 0; i < ends.size(); ++i) {
    for (Index k = i + 1; k < ends.size(); ++k) {
      if (given[i] != given[k]) continue;
      CompletionCandidate candidate{i, k, given[i]};
      if (candidate.given == no_index) {
        if (!(reference > 0) || !may_join(lines, seen[i], seen[k])) continue;
        // No curve is shorter than its chord.
        const double chord = (seen[k].place - seen[i].place).norm();
        if (options.length_weight * chord > options.maximum_cost * reference) continue;
        judge_shape(seen[i], seen[k], junctions.tremble, reference, options, candidate);
        if (candidate.cost() > options.maximum_cost) continue;
      }
      candidates.push_back(std::move(candidate));
    }
  }
  favour_strips(lines, seen, junctions.tremble, candidates);
  const DrawnCover cover(lines, junctions);
  for (CompletionCandidate& candidate : candidates) {
    const SeenEnd& a = seen[candidate.a];
    const SeenEnd& b = seen[candidate.b];
    if (candidate.given == no_index) judge_cover(cover, a.bar == b.bar && a.bar_side == b.bar_side, candidate);
  }
  return candidates;
}

DrawnCover::DrawnCover(const std::vector<CleanLine>& lines, const Junctions& junctions)
    : grid_(line_segments(lines), std::ranges::max(std::views::transform(lines, first_step))) {
  for (Index line = 0; line < lines.size(); ++line) {
    const int round = !lines[line].closed ? 0 : signed_area(lines[line].points) >= 0 ? 1 : -1;
    sides_.push_back(junctions.sides[line] != 0 ? junctions.sides[line] : round);
  }
}

int DrawnCover::missing(const Points& piece) const {
  std::vector<std::pair<double, int>> changes;  // by place along the piece
  for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
    const Vec2& a = piece[i];
    const Vec2& b = piece[i + 1];
    grid_.near_box(a.cwiseMin(b), a.cwiseMax(b), [&](Index k) {
      const GridSegment& s = grid_.segments()[k];
      if (!cross_properly(a, b, s.a, s.b)) return;
      const int to_left = cross(s.b - s.a, b - a) > 0 ? 1 : -1;
      changes.emplace_back(static_cast<double>(i) + crossing_fraction(a, b, s.a, s.b), to_left * sides_[s.line]);
    });
  }
  std::ranges::sort(changes);
  int change = 0;
  int lowest = 0;
  for (const auto& [place, step] : changes) lowest = std::min(lowest, change += step);
  // What has fewer surfaces in front at its last end than at its first one went in between behind an edge that is
  // hidden itself, before it came to where it would lie in the open.
  return std::max(0, std::min(0, change) - lowest);
}

}  // namespace croquis::silhouette
