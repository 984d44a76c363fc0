// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/contour_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/reading/reading_costs.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"

namespace croquis::silhouette {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
// Pieces that a curve is measured by before it is sampled evenly.
constexpr int dense_pieces = 64;
// Ends that turn away from each other further than this are given no longer handles.
constexpr double least_facing = -0.3;
// What follows a line stays so many samples behind it.
constexpr double depth_behind = 2;
// Next to its ends, where it comes from the line itself, it gets no deeper than this share of the way from there.
constexpr double steepness = 0.6;
constexpr int smoothing_passes = 6;
// Midpoint rule over so many pieces: the bending of a half circle is right to 0.1 %.
constexpr int integration_pieces = 24;
// A cap turns round by at most so much: half a turn for a limb's end, more where the line is mostly hidden.
constexpr double most_cap_turn = 1.6 * std::numbers::pi;
// Directions at the ends are known so well, all in all.
constexpr double turn_tolerance = 1;
// What covers a piece is asked of so many chords.
constexpr int judged_pieces = 20;

/// What is seen of a line when it is walked outward through a hidden end.
struct SeenEnd : HiddenEnd {
  const CleanLine* drawn = nullptr;  ///< the line
  Index given = no_index;            ///< the known piece that it belongs to
  Vec2 place = Vec2::Zero();         ///< behind the bar
  const SeenEnd* other = nullptr;    ///< at the line's other end; null where that isn't hidden
  int side = 0;                      ///< the surface lies left (+1) or right (-1), 0 where no stem gives it
  int likely_side = 1;               ///< the same, else by which way the line goes round
  /// How sure it is that the surface lies on the side that the line bends round: 1 for one that nearly closes, 0 for
  /// one whose ends are farther apart than half its length.
  double roundness = 0;
  double turning = 0;  ///< of the line, from its first to its last direction
  int handle = 0;  ///< outer (+1) or inner side (-1) of a handle: two lines from one thing, one goes round the other
};

/// Where a piece would come out beside its bar, it follows the bar within its surface instead.
Points kept_behind(Points curve, const CleanLine& bar, int bar_side, double spacing) {
  const std::vector<double> arcs = arc_lengths(curve, false);
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    const double depth = std::min(depth_behind * spacing, steepness * std::min(arcs[i], arcs.back() - arcs[i]));
    const double parameter = nearest_on_line(bar.points, curve[i], 0, bar.segment_count());
    const auto segment = static_cast<std::size_t>(parameter);
    const Vec2 at = point_at(bar.points, parameter);
    const Vec2 direction = (bar.points[(segment + 1) % bar.points.size()] - bar.points[segment]).normalized();
    const Vec2 inward = bar_side * left_of(direction);
    if (inward.dot(curve[i] - at) < depth) curve[i] = at + depth * inward;
  }
  TaubinOptions smoothing;
  smoothing.passes = smoothing_passes;
  return even_points(taubin_smooth(curve, false, smoothing), false, spacing);
}

/// The known piece that an end belongs to.
Index given_piece_of(const Junctions& junctions, Index end) {
  const auto piece = std::ranges::find_if(
      junctions.given, [&](const GivenPiece& known) { return known.from == end || known.to == end; });
  return piece == junctions.given.end() ? no_index : static_cast<Index>(piece - junctions.given.begin());
}

/// Two lines from one thing, of which one goes round the other, are the two sides of a handle.
void find_handles(std::vector<SeenEnd>& ends) {
  const auto bars = [](const SeenEnd& end) { return std::minmax(end.bar, end.other->bar); };
  const auto is_free = [](const SeenEnd& end) { return end.other != nullptr && end.side == 0; };
  for (SeenEnd& inner : ends) {
    if (!is_free(inner)) continue;
    const Vec2& middle = inner.drawn->points[inner.drawn->points.size() / 2];
    for (SeenEnd& outer : ends) {
      if (!is_free(outer) || inner.line == outer.line || bars(inner) != bars(outer)) continue;
      if (!encloses(outer.drawn->points, middle)) continue;
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
    end.drawn = &lines[end.line];
    end.given = given_piece_of(junctions, position);
    end.place = end.drawn->end(end.at_start);
    const Points& points = end.drawn->points;
    const int outward = end.at_start ? -1 : 1;
    end.side = outward * junctions.sides[end.line];
    end.roundness = std::max(0.0, 1 - 2 * (points.back() - points.front()).norm() / length(points, false));
    end.turning = outward * turning_of(points, false);
    ends.push_back(end);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {  // those of one line are neighbours
    if (ends[i].line != ends[i + 1].line) continue;
    ends[i].other = &ends[i + 1];
    ends[i + 1].other = &ends[i];
  }
  find_handles(ends);
  for (SeenEnd& end : ends) {
    const bool left = (signed_area(end.drawn->points) >= 0) == (end.handle >= 0);
    end.likely_side = end.side != 0 ? end.side : left == end.at_start ? -1 : 1;
  }
  return ends;
}

/// Whether the outline through a, along the curve and back along the line of b closes a limb: it goes round once, with
/// its surface inside as far as that is known, and its caps only turn the way that all of it does. A limb is one line
/// (an ear), or two lines between the same two things (a neck).
bool turns_once(const SeenEnd& a, const SeenEnd& b, const Cubic& curve) {
  // A curve without inflection of its handles turns like its control polygon.
  std::vector<double> caps{turning_of(curve, false)};
  double whole = a.turning + caps[0];
  if (a.line != b.line) {
    // What other lines end at is more likely a strand that goes on than a limb.
    if (a.side != 0 || b.side != 0 || a.other == nullptr || b.other == nullptr) return false;
    if (a.bar != b.bar || a.other->bar != b.other->bar || a.bar == a.other->bar) return false;
    const Cubic cap = completion_curve(b.other->place, b.other->tangent, a.other->place, a.other->tangent);
    caps.push_back(turning_of(cap, false));
    whole += caps[1] - b.turning;
  }
  const int sense = whole > 0 ? 1 : -1;
  return std::abs(sense * whole - 2 * std::numbers::pi) < turn_tolerance && whole * a.side >= 0 &&
         std::ranges::all_of(caps, [&](double cap) { return sense * cap >= 0 && sense * cap <= most_cap_turn; });
}

/// What a piece costs at most, since it closes a limb.
double highest_cost(const SeenEnd& a, const SeenEnd& b, const Cubic& curve, double jitter) {
  // How far curves turn says little of an unsteady hand's lines: strands of knots would be closed as necks.
  if (a.line != b.line) return jitter < 1 && turns_once(a, b, curve) ? costs::limb_cap / (1 - jitter) : no_limit;
  // A line that passes behind itself goes on there, and the two sides of a handle belong together.
  if (a.bar == a.line || b.bar == b.line || a.handle != 0) return no_limit;
  return turns_once(a, b, curve) ? costs::limb_cap : no_limit;
}

/// How exactly the ends of a strip must fit.
struct StripFit {
  double side_cosine = 1;      ///< both ends of a side point at one another at least so well
  double strip_cosine = 1;     ///< the strip's two ends do, whose directions are those of the middle between its sides
  double parallel_cosine = 1;  ///< the two sides run in one direction
  double most_taper = 0;       ///< share by which it is narrower at one end
  double least_length = 1;     ///< in widths
  double most_length = no_limit;
};

// Within 30, 12 and 8 degrees: a hand's last samples are uncertain.
constexpr StripFit strip_fit{0.866, 0.978, 0.99, 0.25, 1};
// Behind a strand a strip is hidden for a short piece only, and an unsteady hand may turn its ends and make it
// narrower: within 75, 60 and 40 degrees.
constexpr StripFit strand_fit{0.25, 0.5, 0.77, 0.6, 0.5, 2.5};
// A strand is narrow: no wider than this share of the size of its outlines.
constexpr double most_share_of_bar = 0.25;
// A strip is crossed by at most so many others.
constexpr double crossing_sine = 0.25;
constexpr int most_crossings = 1;
// With so many others like its two ends behind the same line, that go on nowhere, it is two limbs among limbs.
constexpr int most_limbs_alike = 2;
// Limbs are alike whose outlines are as long but for this factor.
constexpr double alike_length = 1.6;

/// One side of what may be a strip.
struct Side {
  Index candidate = 0;
  std::array<const SeenEnd*, 2> ends{};
  Vec2 direction = Vec2::Zero();
  double facing = 1;  ///< cosine between it and the worse of its two ends
  int surface = 0;    ///< on its left (+1) or right (-1), 0 not known
};

struct Strip {
  std::array<Side, 2> sides;  ///< in the same direction
  double length = 0;
  double least_width = 0;  ///< at its narrower end; not positive when the two sides don't bound a strip
  double most_width = 0;
};

/// The candidates that run nearly straight from one end to the other.
std::vector<Side> straight_sides(const std::vector<SeenEnd>& ends, const std::vector<CompletionCandidate>& candidates) {
  // A straight line goes round neither of its sides.
  const auto surface = [](const SeenEnd& end) { return end.side != 0 || end.roundness > 0 ? end.likely_side : 0; };
  std::vector<Side> sides;
  for (Index c = 0; c < candidates.size(); ++c) {
    const SeenEnd& a = ends[candidates[c].a];
    const SeenEnd& b = ends[candidates[c].b];
    if (candidates[c].given != no_index || surface(a) * surface(b) > 0) continue;
    const Vec2 direction = (b.place - a.place).normalized();
    const double facing = std::min(a.tangent.dot(direction), -b.tangent.dot(direction));
    if (facing < strand_fit.side_cosine) continue;
    sides.push_back({c, {&a, &b}, direction, facing, surface(a) != 0 ? surface(a) : -surface(b)});
  }
  return sides;
}

Strip strip_between(const Side& one, Side other) {
  if (one.direction.dot(other.direction) < 0) {
    std::swap(other.ends[0], other.ends[1]);
    other.direction = -other.direction;
    other.surface = -other.surface;
  }
  Strip strip{{one, other}, (one.ends[1]->place - one.ends[0]->place).norm()};
  if (one.surface * other.surface > 0) return strip;
  const auto offset = [&](std::size_t at) { return cross(one.direction, other.ends[at]->place - one.ends[at]->place); };
  int between = one.surface != 0 ? one.surface : -other.surface;
  if (between == 0) between = offset(0) > 0 ? 1 : -1;
  std::tie(strip.least_width, strip.most_width) = std::minmax({between * offset(0), between * offset(1)});
  return strip;
}

/// Whether what is seen of it goes straight on, for as long as the strip is wide: the arms of a character don't.
bool goes_on(const Strip& strip, double least_cosine) {
  const auto middle = [&](std::size_t at) -> Vec2 {
    return (strip.sides[0].ends[at]->place + strip.sides[1].ends[at]->place) / 2;
  };
  const auto chord = [&](const SeenEnd& end) { return end_chord(end.drawn->points, end.at_start, strip.most_width); };
  const auto outward = [&](std::size_t at) -> Vec2 {
    return (chord(*strip.sides[0].ends[at]) + chord(*strip.sides[1].ends[at])).normalized();
  };
  const Vec2 along = (middle(1) - middle(0)).normalized();
  return std::min(along.dot(outward(0)), -along.dot(outward(1))) >= least_cosine;
}

bool fits(const Strip& strip, const StripFit& fit) {
  const auto& [one, other] = strip.sides;
  return std::min(one.facing, other.facing) >= fit.side_cosine &&
         one.direction.dot(other.direction) >= fit.parallel_cosine &&
         strip.least_width > (1 - fit.most_taper) * strip.most_width &&
         strip.length > fit.least_length * strip.most_width && strip.length < fit.most_length * strip.most_width &&
         goes_on(strip, fit.strip_cosine);
}

/// Whether it may be a strand behind a strand: both sides go in behind one line and come out behind one line, and what
/// lies between is narrow beside them.
bool is_behind_strand(const std::vector<CleanLine>& lines, const Strip& strip) {
  return std::ranges::all_of(std::array{0U, 1U}, [&](std::size_t at) {
    const Index bar = strip.sides[0].ends[at]->bar;
    return bar == strip.sides[1].ends[at]->bar && strip.length <= most_share_of_bar * lines[bar].size;
  });
}

bool crosses(const Strip& strip, const Strip& other) {
  const Side& one = strip.sides[0];
  const Side& two = other.sides[0];
  return std::abs(cross(one.direction, two.direction)) > crossing_sine &&
         segments_cross(one.ends[0]->place, one.ends[1]->place, two.ends[0]->place, two.ends[1]->place);
}

/// Whether both sides of a strip end in one line, which is the outline of a limb.
bool ends_in(const Strip& strip, std::size_t at, Index line) {
  return std::ranges::all_of(strip.sides, [&](const Side& side) { return side.ends[at]->line == line; });
}

/// Whether a strip is two limbs among others: outlines like those of its ends pass behind the same line without being
/// part of a strip.
bool is_among_limbs(const std::vector<SeenEnd>& ends, const Strip& strip, const std::vector<Strip>& strips) {
  const SeenEnd& one = *strip.sides[0].ends[0];
  const SeenEnd& other = *strip.sides[0].ends[1];
  const auto alike = [&](const SeenEnd& end) {
    const bool same_body = end.bar == one.bar && end.other != nullptr && end.other->bar == end.bar;
    const auto [less, more] = std::minmax(one.drawn->size, end.drawn->size);
    return same_body && end.bar != end.line && more < alike_length * less;
  };
  if (!ends_in(strip, 0, one.line) || !ends_in(strip, 1, other.line) || !alike(one) || !alike(other)) return false;
  const auto in_strip = [&](const SeenEnd& end) {
    return std::ranges::any_of(
        strips, [&](const Strip& some) { return ends_in(some, 0, end.line) || ends_in(some, 1, end.line); });
  };
  const auto limbs =
      std::ranges::count_if(ends, [&](const SeenEnd& end) { return end.at_start && alike(end) && !in_strip(end); });
  return limbs >= most_limbs_alike;
}

/// Sets the factor of candidates that carry both sides of a strip straight on behind something, at the same width: an
/// arrow through a heart, a stick behind a disc. Such a strip is one part, however far it is hidden: its sides cost
/// less.
///
/// Strips of which three or more would cross one another, and those that lie among limbs like their two ends, cost
/// more: they are petals or arms all round.
///
/// Behind something as narrow as another strip, the two sides may be bent aside and less even: there an unsteady hand
/// turns the ends of strands of knots and chains.
/// O(s²) for s straight candidates.
void favour_strips(const std::vector<CleanLine>& lines, const std::vector<SeenEnd>& ends, double jitter,
                   std::vector<CompletionCandidate>& candidates) {
  const std::vector<Side> sides = straight_sides(ends, candidates);
  std::vector<Strip> strips;
  for (auto one = sides.begin(); one != sides.end(); ++one) {
    for (auto other = one + 1; other != sides.end(); ++other) {
      const Strip strip = strip_between(*one, *other);
      if (strip.least_width <= 0) continue;
      const bool bent = jitter > 0 && is_behind_strand(lines, strip);
      if (fits(strip, strip_fit) || (bent && fits(strip, strand_fit))) strips.push_back(strip);
    }
  }
  for (const Strip& strip : strips) {
    const auto crossed = std::ranges::count_if(strips, [&](const Strip& other) { return crosses(strip, other); });
    const bool among = crossed > most_crossings || is_among_limbs(ends, strip, strips);
    for (const Side& side : strip.sides) {
      double& factor = candidates[side.candidate].strip;
      factor = among ? std::max(factor, costs::crossed_strip) : costs::strip;
    }
  }
}

/// The length that completions are measured by: the median over the hidden ends that have to be joined of the distance
/// to the nearest other. O(n²) for n ends.
double reference_length(const std::vector<CleanLine>& lines, const Junctions& junctions) {
  std::vector<Vec2> places;
  for (Index e = 0; e < junctions.ends.size(); ++e) {
    const HiddenEnd& end = junctions.ends[e];
    if (given_piece_of(junctions, e) == no_index) places.push_back(lines[end.line].end(end.at_start));
  }
  return typical_spacing(places, std::vector<char>(places.size(), 1)).value_or(0);
}

bool may_join(const SeenEnd& a, const SeenEnd& b) {
  const std::string& first = a.drawn->object;
  const std::string& second = b.drawn->object;
  return (first.empty() || second.empty() || first == second) && a.side * b.side <= 0;
}

/// Brings the shapes that keep a candidate covered to the front, and makes it dearer when there is none.
/// @param sides of the lines; a closed line has its surface within where it isn't known
void judge_cover(const std::vector<CleanLine>& lines, std::vector<int> sides, const std::vector<SeenEnd>& ends,
                 std::vector<CompletionCandidate>& candidates) {
  double longest_step = 0;
  for (Index line = 0; line < lines.size(); ++line) {
    const Points& points = lines[line].points;
    longest_step = std::max(longest_step, (points[1] - points[0]).norm());
    if (sides[line] == 0 && lines[line].closed) sides[line] = signed_area(points) >= 0 ? 1 : -1;
  }
  const SegmentGrid drawn(segments_of(lines), longest_step);
  for (CompletionCandidate& candidate : candidates) {
    if (candidate.given != no_index) continue;
    std::array<double, completion_shapes.size()> open{};
    for (const std::uint8_t shape : candidate.shapes) {
      const Points chords = completion_chords(candidate.curve, completion_shapes[shape], judged_pieces);
      open[shape] = costs::in_the_open * missing_surfaces(drawn, sides, chords);
      if (shape == 0 && open[shape] <= 0) break;
    }
    std::ranges::stable_sort(candidate.shapes, {}, [&](std::uint8_t shape) { return open[shape]; });
    candidate.open = open[candidate.shapes.front()];
    const SeenEnd& a = ends[candidate.a];
    const SeenEnd& b = ends[candidate.b];
    const bool one_bar = a.bar == b.bar && a.bar_side == b.bar_side;
    if (candidate.open > 0 && one_bar) candidate.shapes.insert(candidate.shapes.begin(), kept_behind_shape);
  }
}

}  // namespace

Cubic completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b) {
  const double distance = (b - a).norm();
  const Vec2 across = distance > 0 ? Vec2((b - a) / distance) : Vec2(1, 0);
  const double facing = 0.5 * (tangent_a.dot(across) - tangent_b.dot(across));
  const double handle = 2.0 / 3.0 * distance / (1 + std::max(facing, least_facing));
  return {a, a + handle * tangent_a, b + handle * tangent_b, b};
}

Points completion_chords(const Cubic& curve, const CompletionShape& shape, int pieces) {
  const Vec2 first = curve[1] - curve[0];
  const Vec2 last = curve[2] - curve[3];
  const Vec2 a = curve[0] + shape.reach * first;
  const Vec2 d = curve[3] + shape.reach * last;
  const Vec2 b = a + shape.handles * first;
  const Vec2 c = d + shape.handles * last;
  Points points;
  if (shape.reach > 0) points.push_back(curve[0]);
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1 - t;
    points.emplace_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
  if (shape.reach > 0) points.push_back(curve[3]);
  return points;
}

Points completion_points(const Cubic& curve, const CompletionShape& shape, double spacing, const CleanLine& bar,
                         int bar_side) {
  const Points dense = completion_chords(curve, shape, dense_pieces);
  const Points points = even_points(dense, false, std::min(spacing, length(dense, false) / 4));
  return shape.kept_behind ? kept_behind(points, bar, bar_side, spacing) : points;
}

double turning_of(std::span<const Vec2> points, bool closed) {
  const std::size_t count = points.size();
  double sum = 0;
  for (std::size_t i = 0; i < (closed ? count : count - 2); ++i) {
    const Vec2& corner = points[(i + 1) % count];
    const Vec2 before = corner - points[i];
    const Vec2 after = points[(i + 2) % count] - corner;
    sum += std::atan2(cross(before, after), before.dot(after));
  }
  return sum;
}

double CompletionCandidate::cost() const {
  const double alone = std::min(shape_cost, most) + open;
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

std::vector<CompletionCandidate> completion_candidates(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                                       const std::vector<Index>& ends,
                                                       const CompletionOptions& options) {
  const std::vector<SeenEnd> seen = seen_ends(lines, junctions, ends);
  const double reference = reference_length(lines, junctions);
  std::vector<CompletionCandidate> candidates;
  for (Index i = 0; i < ends.size(); ++i) {
    for (Index k = i + 1; k < ends.size(); ++k) {
      const SeenEnd& a = seen[i];
      const SeenEnd& b = seen[k];
      if (a.given != b.given) continue;
      CompletionCandidate candidate{i, k, a.given};
      if (candidate.given == no_index) {
        if (!(reference > 0) || !may_join(a, b)) continue;
        // No curve is shorter than its chord.
        if (options.length_weight * (b.place - a.place).norm() > options.maximum_cost * reference) continue;
        const int agreed = a.likely_side == -b.likely_side ? a.likely_side : 0;
        candidate.curve = completion_curve(a.place, a.tangent, b.place, b.tangent);
        candidate.shape_cost = completion_cost(candidate.curve, agreed, reference, options);
        if (agreed == 0) candidate.shape_cost += costs::opposite_sides * std::min(a.roundness, b.roundness);
        candidate.most = highest_cost(a, b, candidate.curve, junctions.jitter);
        if (candidate.cost() > options.maximum_cost) continue;
      }
      candidates.push_back(std::move(candidate));
    }
  }
  favour_strips(lines, seen, junctions.jitter, candidates);
  judge_cover(lines, junctions.sides, seen, candidates);
  return candidates;
}

int missing_surfaces(const SegmentGrid& drawn, const std::vector<int>& sides, const Points& piece) {
  std::vector<std::pair<double, int>> changes;  // by place along the piece
  for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
    const Vec2& a = piece[i];
    const Vec2& b = piece[i + 1];
    drawn.near_box(a.cwiseMin(b), a.cwiseMax(b), [&](Index k) {
      const GridSegment& s = drawn.segments()[k];
      if (!segments_cross(a, b, s.a, s.b)) return;
      const int to_left = cross(s.b - s.a, b - a) > 0 ? 1 : -1;
      changes.emplace_back(static_cast<double>(i) + crossing_fraction(a, b, s.a, s.b), to_left * sides[s.line]);
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
