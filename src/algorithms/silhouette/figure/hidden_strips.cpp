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
bool goes_on(const std::vector<CleanLine>& lines, const Strip& strip, double least_cosine) {
  std::array<Vec2, 2> middle{Vec2::Zero(), Vec2::Zero()};
  std::array<Vec2, 2> outward{Vec2::Zero(), Vec2::Zero()};
  for (const std::size_t at : {0U, 1U}) {
    for (const Side& side : strip.sides) {
      middle[at] += side.ends[at]->place / 2;
      outward[at] += end_chord(lines[side.ends[at]->line].points, side.ends[at]->at_start, strip.most_width);
    }
  }
  const Vec2 along = (middle[1] - middle[0]).normalized();
  return std::min(along.dot(outward[0].normalized()), -along.dot(outward[1].normalized())) >= least_cosine;
}

bool fits(const std::vector<CleanLine>& lines, const Strip& strip, const StripFit& fit) {
  const auto& [one, other] = strip.sides;
  return std::min(one.facing, other.facing) >= fit.side_cosine &&
         one.direction.dot(other.direction) >= fit.parallel_cosine &&
         strip.least_width > (1 - fit.most_taper) * strip.most_width &&
         strip.length > fit.least_length * strip.most_width && goes_on(lines, strip, fit.strip_cosine);
}

/// Whether it may be a strand behind a strand: both sides go in behind one line and come out behind one line, and what
/// lies between is narrow beside them.
bool is_behind_strand(const std::vector<CleanLine>& lines, const Strip& strip) {
  const auto covers = [&](std::size_t at) {
    const Index bar = strip.sides[0].ends[at]->bar;
    return bar == strip.sides[1].ends[at]->bar && strip.length <= most_share_of_bar * lines[bar].size;
  };
  return strip.length < most_length_behind_strand * strip.most_width && covers(0) && covers(1);
}

bool crosses(const Strip& strip, const Strip& other) {
  const Side& one = strip.sides[0];
  const Side& two = other.sides[0];
  return std::abs(cross(one.direction, two.direction)) > crossing_sine &&
         cross_properly(one.ends[0]->place, one.ends[1]->place, two.ends[0]->place, two.ends[1]->place);
}

/// Whether both sides of a strip end in one line, which is the outline of a limb.
bool ends_in(const Strip& strip, std::size_t at, Index line) {
  return std::ranges::all_of(strip.sides, [&](const Side& side) { return side.ends[at]->line == line; });
}

/// Whether a strip is two limbs among others: outlines like those of its ends pass behind the same line without being
/// part of a strip.
bool is_among_limbs(const std::vector<CleanLine>& lines, const std::vector<SeenEnd>& ends, const Strip& strip,
                    const std::vector<Strip>& strips) {
  const auto& [one, other] = strip.sides[0].ends;
  const auto alike = [&](const SeenEnd& end) {
    const auto [less, more] = std::minmax(lines[one->line].size, lines[end.line].size);
    return one->body() == end.body() && more < alike_length * less;
  };
  if (!ends_in(strip, 0, one->line) || !ends_in(strip, 1, other->line) || !alike(*other)) return false;
  const auto limbs = std::ranges::count_if(ends, [&](const SeenEnd& end) {
    return end.at_start && end.body() != no_index && alike(end) && std::ranges::none_of(strips, [&](const Strip& some) {
             return ends_in(some, 0, end.line) || ends_in(some, 1, end.line);
           });
  });
  return limbs >= most_limbs_alike;
}

}  // namespace

void favour_strips(const std::vector<CleanLine>& lines, const std::vector<SeenEnd>& ends, double tremble,
                   std::vector<CompletionCandidate>& candidates) {
  const std::vector<Side> sides = straight_sides(ends, candidates);
  std::vector<Strip> strips;
  for (auto one = sides.begin(); one != sides.end(); ++one) {
    for (auto other = one + 1; other != sides.end(); ++other) {
      const Strip strip = strip_between(*one, *other);
      if (strip.least_width <= 0) continue;
      const bool bent = tremble > 0 && is_behind_strand(lines, strip);
      if (fits(lines, strip, strip_fit) || (bent && fits(lines, strip, strand_fit))) strips.push_back(strip);
    }
  }
  for (const Strip& strip : strips) {
    const auto crossed = std::ranges::count_if(strips, [&](const Strip& other) { return crosses(strip, other); });
    const bool among = crossed > most_crossings || is_among_limbs(lines, ends, strip, strips);
    for (const Side& side : strip.sides) {
      double& factor = candidates[side.candidate].strip;
      factor = among ? std::max(factor, costs::crossed_strip) : costs::strip;
    }
  }
}

}  // namespace croquis::silhouette
