// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/hidden_strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/reading/reading_costs.h"

namespace croquis::silhouette {
namespace {

/// How exactly the ends of a strip must fit.
struct StripFit {
  double side_cosine = 1;      ///< both ends of a side point at one another at least so well
  double strip_cosine = 1;     ///< the strip's two ends do, whose directions are those of the middle between its sides
  double parallel_cosine = 1;  ///< the two sides run in one direction
  double most_taper = 0;       ///< share by which it is narrower at one end
  double least_length = 1;     ///< in widths
};

// Within 30, 12 and 8 degrees: a hand's last samples are uncertain.
constexpr StripFit strip_fit{0.866, 0.978, 0.99, 0.25, 1};
// Behind a strand a strip is hidden for a short piece only, and a hand's tremble may turn its ends and make it
// narrower: within 75, 60 and 40 degrees.
constexpr StripFit strand_fit{0.25, 0.5, 0.77, 0.6, 0.5};
// So long at most, in widths of the strip.
constexpr double most_length_behind_strand = 2.5;
// A strand is narrow: no wider than this share of the size of its outlines, and those run in opposite directions.
constexpr double most_share_of_bar = 0.25;
constexpr double opposite_cosine = -0.3;
// Their directions are taken over so many steps to either side.
constexpr double bar_steps = 4;
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
  std::array<const HiddenEnd*, 2> ends{};
  std::array<Vec2, 2> at{Vec2::Zero(), Vec2::Zero()};  ///< where the ends are
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
std::vector<Side> straight_sides(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                 const std::vector<Index>& ends, const std::vector<int>& surface,
                                 const std::vector<CompletionCandidate>& candidates) {
  std::vector<Side> sides;
  for (Index c = 0; c < candidates.size(); ++c) {
    const auto [a, b] = std::pair(candidates[c].a, candidates[c].b);
    if (candidates[c].given != no_index || surface[a] * surface[b] > 0) continue;
    Side side{.candidate = c, .ends = {&junctions.ends[ends[a]], &junctions.ends[ends[b]]}};
    side.surface = surface[a] != 0 ? surface[a] : -surface[b];
    for (const std::size_t at : {0U, 1U}) side.at[at] = lines[side.ends[at]->line].end(side.ends[at]->at_start);
    side.direction = (side.at[1] - side.at[0]).normalized();
    side.facing = std::min(side.ends[0]->tangent.dot(side.direction), -side.ends[1]->tangent.dot(side.direction));
    if (side.facing >= strand_fit.side_cosine) sides.push_back(side);
  }
  return sides;
}

Strip strip_between(const Side& one, Side other) {
  if (one.direction.dot(other.direction) < 0) {
    std::ranges::reverse(other.ends);
    std::ranges::reverse(other.at);
    other.direction = -other.direction;
    other.surface = -other.surface;
  }
  Strip strip{.sides = {one, other}, .length = (one.at[1] - one.at[0]).norm()};
  if (one.surface * other.surface > 0) return strip;
  int between = one.surface != 0 ? one.surface : -other.surface;
  if (between == 0) between = cross(one.direction, other.at[0] - one.at[0]) > 0 ? 1 : -1;
  std::tie(strip.least_width, strip.most_width) =
      std::minmax({between * cross(one.direction, other.at[0] - one.at[0]),
                   between * cross(one.direction, other.at[1] - one.at[1])});
  return strip;
}

/// Whether what is seen of it goes straight on, for as long as the strip is wide: the arms of a character don't.
bool goes_on(const std::vector<CleanLine>& lines, const Strip& strip, double least_cosine) {
  const auto& [one, other] = strip.sides;
  const Vec2 along = (one.at[1] + other.at[1] - one.at[0] - other.at[0]).normalized();
  for (const std::size_t at : {0U, 1U}) {
    Vec2 outward = Vec2::Zero();
    for (const Side& side : strip.sides) {
      outward += end_chord(lines[side.ends[at]->line].points, side.ends[at]->at_start, strip.most_width);
    }
    if ((at == 0 ? 1 : -1) * outward.normalized().dot(along) < least_cosine) return false;
  }
  return true;
}

bool fits(const std::vector<CleanLine>& lines, const Strip& strip, const StripFit& fit) {
  const auto& [one, other] = strip.sides;
  const double aside = std::abs(one.direction.dot(other.at[0] - one.at[0]));
  return std::min(one.facing, other.facing) >= fit.side_cosine &&
         one.direction.dot(other.direction) >= fit.parallel_cosine &&
         strip.least_width > (1 - fit.most_taper) * strip.most_width &&
         strip.length > fit.least_length * strip.most_width && aside < strip.most_width + 0.5 * strip.length &&
         goes_on(lines, strip, fit.strip_cosine);
}

/// The direction of a bar where an end passes behind it, with its surface on the left.
Vec2 bar_direction(const CleanLine& bar, const HiddenEnd& end) {
  const Index last = bar.segment_count();
  const double reach = std::min(bar_steps, last / 4.0);
  const auto place = [&](double parameter) {
    return point_at(bar.points,
                    bar.closed ? std::fmod(parameter + last, last) : std::clamp<double>(parameter, 0, last));
  };
  return end.bar_side * (place(end.bar_parameter + reach) - place(end.bar_parameter - reach)).normalized();
}

/// Whether it may be a strand behind a strand: both sides go in behind one line, come out behind one line that runs the
/// other way, and what lies between is narrow beside them. A limb, which ends twice at its body, has both of its own
/// sides.
bool is_behind_strand(const std::vector<CleanLine>& lines, const std::vector<Index>& bodies, const Strip& strip) {
  if (strip.length >= most_length_behind_strand * strip.most_width) return false;
  std::array<Vec2, 2> along;  // of what covers it
  for (const std::size_t at : {0U, 1U}) {
    const auto [one, other] = std::pair(strip.sides[0].ends[at], strip.sides[1].ends[at]);
    if (one->bar != other->bar || strip.length > most_share_of_bar * lines[one->bar].size) return false;
    if (one->line != other->line && (bodies[one->line] != no_index || bodies[other->line] != no_index)) return false;
    along[at] = (bar_direction(lines[one->bar], *one) + bar_direction(lines[one->bar], *other)).normalized();
  }
  return along[0].dot(along[1]) < opposite_cosine;
}

/// The outlines of limbs that both sides end in; no_index where they end in two lines.
std::array<Index, 2> limbs_of(const Strip& strip) {
  std::array<Index, 2> limbs{no_index, no_index};
  for (const std::size_t at : {0U, 1U}) {
    const Index line = strip.sides[0].ends[at]->line;
    if (line == strip.sides[1].ends[at]->line) limbs[at] = line;
  }
  return limbs;
}

bool crosses(const Strip& one, const Strip& other) {
  const auto& [a, b] = std::tie(one.sides[0], other.sides[0]);
  return std::abs(cross(a.direction, b.direction)) > crossing_sine &&
         cross_properly(a.at[0], a.at[1], b.at[0], b.at[1]);
}

/// Whether a strip is two limbs among others: outlines like those of its ends pass behind the same line without being
/// part of a strip.
bool is_among_limbs(const std::vector<CleanLine>& lines, const std::vector<Index>& bodies, const Strip& strip,
                    const std::vector<Strip>& strips) {
  const auto [one, other] = limbs_of(strip);
  const auto alike = [&](Index a, Index b) {
    return std::max(lines[a].size, lines[b].size) < alike_length * std::min(lines[a].size, lines[b].size);
  };
  if (one == no_index || other == no_index || !alike(one, other) || bodies[one] != bodies[other]) return false;
  int count = 0;
  for (Index line = 0; line < lines.size(); ++line) {
    if (line == one || line == other || bodies[line] == no_index || bodies[line] != bodies[one] || !alike(one, line))
      continue;
    const bool in_strip =
        std::ranges::any_of(strips, [&](const Strip& some) { return std::ranges::count(limbs_of(some), line) > 0; });
    if (!in_strip) ++count;
  }
  return count >= most_limbs_alike;
}

}  // namespace

void favour_strips(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
                   const std::vector<int>& side, std::vector<CompletionCandidate>& candidates) {
  const std::vector<Index> bodies = bodies_of_limbs(junctions, lines.size());
  const std::vector<Side> sides = straight_sides(lines, junctions, ends, side, candidates);
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const Strip strip = strip_between(sides[i], sides[k]);
      if (strip.least_width <= 0) continue;
      if (fits(lines, strip, strip_fit) ||
          (junctions.tremble > 0 && is_behind_strand(lines, bodies, strip) && fits(lines, strip, strand_fit))) {
        strips.push_back(strip);
      }
    }
  }
  for (const Strip& strip : strips) {
    const auto crossed = std::ranges::count_if(strips, [&](const Strip& other) { return crosses(strip, other); });
    const bool among = crossed > most_crossings || is_among_limbs(lines, bodies, strip, strips);
    for (const Side& one : strip.sides) {
      double& factor = candidates[one.candidate].strip;
      factor = among ? std::max(factor, costs::crossed_strip) : costs::strip;
    }
  }
}

}  // namespace croquis::silhouette
