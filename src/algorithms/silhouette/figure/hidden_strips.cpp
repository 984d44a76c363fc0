// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/hidden_strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace croquis::silhouette {
namespace {

// Both ends of a side point at one another within 30 degrees: a hand's last samples are uncertain.
constexpr double side_cosine = 0.866;
// The strip's two ends, whose directions are those of the middle between its sides, do so within 12 degrees.
constexpr double strip_cosine = 0.978;
// The two sides of a strip run in one direction within 8 degrees, and are as far apart at both ends but for a fourth.
constexpr double parallel_cosine = 0.99;
constexpr double most_taper = 0.25;
// What a side of a strip costs, as a share of what it would cost by itself.
constexpr double strip_share = 0.15;
// And at most so much, however far it is hidden: less than two caps.
constexpr double most_strip_cost = 0.6;
// A strip is crossed by at most so many others; one that is crossed by more costs this much more.
constexpr double crossing_sine = 0.25;
constexpr int most_crossings = 1;
constexpr double crossed_factor = 1.5;
// With so many others like its two ends behind the same line, that go on nowhere, it is two limbs among limbs.
constexpr int most_limbs_alike = 2;
// Limbs are alike whose outlines are as long but for this factor.
constexpr double alike_length = 1.6;

/// One side of what may be a strip.
struct Side {
  Index candidate = 0;
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  Vec2 direction = Vec2::Zero();
  int surface = 0;              ///< on its left (+1) or right (-1), 0 not known
  std::array<Index, 2> ends{};  ///< of the junctions

  void turn_over() {
    std::swap(from, to);
    std::swap(ends[0], ends[1]);
    direction = -direction;
    surface = -surface;
  }
};

struct Strip {
  Side first;
  Side second;  ///< in the same direction
};

class StripSearch {
 public:
  StripSearch(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
              const std::vector<int>& side)
      : lines_(lines),
        junctions_(junctions),
        ends_(ends),
        side_(side),
        bodies_(bodies_of_limbs(junctions, lines.size())) {}

  void favour(std::vector<CompletionCandidate>& candidates) const {
    const std::vector<Strip> strips = find_strips(candidates);
    for (const Strip& strip : strips) {
      const auto crossed = std::count_if(strips.begin(), strips.end(), [&](const Strip& other) {
        return std::abs(cross(strip.first.direction, other.first.direction)) > crossing_sine &&
               cross_properly(strip.first.from, strip.first.to, other.first.from, other.first.to);
      });
      const bool among = crossed > most_crossings || limbs_alike(strip, strips) >= most_limbs_alike;
      for (const Index side : {strip.first.candidate, strip.second.candidate}) {
        double& factor = candidates[side].strip_factor;
        factor = among ? std::max(factor, crossed_factor) : strip_share;
      }
    }
  }

 private:
  std::vector<Strip> find_strips(const std::vector<CompletionCandidate>& candidates) const {
    std::vector<Side> sides;
    for (Index c = 0; c < candidates.size(); ++c) add_side(candidates[c], c, sides);
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = i + 1; k < sides.size(); ++k) {
        Strip strip{sides[i], sides[k]};
        if (strip.first.direction.dot(strip.second.direction) < 0) strip.second.turn_over();
        const double width = even_width(strip);
        if (width > 0 && goes_on(strip, width)) strips.push_back(strip);
      }
    }
    return strips;
  }

  void add_side(const CompletionCandidate& candidate, Index index, std::vector<Side>& sides) const {
    const int surface = side_[candidate.a] != 0 ? side_[candidate.a] : -side_[candidate.b];
    if (candidate.given != no_index || side_[candidate.a] * side_[candidate.b] > 0) return;
    const HiddenEnd& a = junctions_.ends[ends_[candidate.a]];
    const HiddenEnd& b = junctions_.ends[ends_[candidate.b]];
    Side side{index,   lines_[a.line].end(a.at_start),          lines_[b.line].end(b.at_start), Vec2::Zero(),
              surface, {ends_[candidate.a], ends_[candidate.b]}};
    side.direction = (side.to - side.from).normalized();
    if (a.tangent.dot(side.direction) < side_cosine || -b.tangent.dot(side.direction) < side_cosine) return;
    sides.push_back(side);
  }

  /// The width of a strip, 0 when that isn't even or wider than long.
  static double even_width(const Strip& strip) {
    const Side& one = strip.first;
    const Side& other = strip.second;
    if (one.direction.dot(other.direction) < parallel_cosine || one.surface * other.surface > 0) return 0;
    int between = one.surface != 0 ? one.surface : -other.surface;
    if (between == 0) between = cross(one.direction, other.from - one.from) > 0 ? 1 : -1;
    const double begin = between * cross(one.direction, other.from - one.from);
    const double end = between * cross(one.direction, other.to - one.to);
    const double width = std::max(begin, end);
    const double length = (one.to - one.from).norm();
    const bool beside = std::abs(one.direction.dot(other.from - one.from)) < width + 0.5 * length;
    const bool even = std::min(begin, end) > (1 - most_taper) * width && width < length && beside;
    return even ? width : 0;
  }

  /// Whether what is seen of it goes straight on, for as long as the strip is wide: the arms of a character don't.
  bool goes_on(const Strip& strip, double width) const {
    const Vec2 along =
        (0.5 * (strip.first.to + strip.second.to) - 0.5 * (strip.first.from + strip.second.from)).normalized();
    for (const std::size_t at : {0U, 1U}) {
      const Vec2 outward = (chord(strip.first.ends[at], width) + chord(strip.second.ends[at], width)).normalized();
      if ((at == 0 ? 1 : -1) * outward.dot(along) < strip_cosine) return false;
    }
    return true;
  }

  Vec2 chord(Index end, double reach) const {
    const HiddenEnd& hidden = junctions_.ends[end];
    return end_chord(lines_[hidden.line].points, hidden.at_start, reach);
  }

  /// The outline of a limb that both sides end in; no_index where they end in two lines.
  Index limb_at(const Strip& strip, std::size_t at) const {
    const Index line = junctions_.ends[strip.first.ends[at]].line;
    return line == junctions_.ends[strip.second.ends[at]].line ? line : no_index;
  }

  /// How many outlines like those of the strip's ends pass behind the same line without being part of a strip.
  int limbs_alike(const Strip& strip, const std::vector<Strip>& strips) const {
    const Index one = limb_at(strip, 0);
    const Index other = limb_at(strip, 1);
    if (one == no_index || other == no_index || !alike(one, other)) return 0;
    int count = 0;
    for (Index line = 0; line < lines_.size(); ++line) {
      if (line == one || line == other || !alike(one, line) || bodies_[line] == no_index) continue;
      if (bodies_[line] != bodies_[one] || bodies_[line] != bodies_[other]) continue;
      const bool in_strip = std::any_of(strips.begin(), strips.end(), [&](const Strip& some) {
        return limb_at(some, 0) == line || limb_at(some, 1) == line;
      });
      count += in_strip ? 0 : 1;
    }
    return count;
  }

  bool alike(Index a, Index b) const {
    return std::max(lines_[a].size, lines_[b].size) < alike_length * std::min(lines_[a].size, lines_[b].size);
  }

  const std::vector<CleanLine>& lines_;
  const Junctions& junctions_;
  const std::vector<Index>& ends_;
  const std::vector<int>& side_;
  std::vector<Index> bodies_;  ///< per line, see bodies_of_limbs
};

}  // namespace

double strip_cost(double plain, double factor) {
  return factor < 1 ? std::min(factor * plain, most_strip_cost) : factor * plain;
}

void favour_strips(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
                   const std::vector<int>& side, std::vector<CompletionCandidate>& candidates) {
  StripSearch(lines, junctions, ends, side).favour(candidates);
}

}  // namespace croquis::silhouette
