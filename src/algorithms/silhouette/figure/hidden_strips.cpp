// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/hidden_strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace croquis::silhouette {
namespace {

// Straight: both ends point at one another within 10 degrees.
constexpr double straight_cosine = 0.985;
// The two sides of a strip run in one direction within 6 degrees, and are as far apart at both ends but for a fifth.
constexpr double parallel_cosine = 0.9945;
constexpr double most_taper = 0.2;
// What is seen of them next to their ends keeps the direction within 8 degrees.
constexpr double drawn_cosine = 0.99;
// What a side of a strip costs, as a share of what it would cost by itself.
constexpr double strip_share = 0.15;
// And at most so much, however far it is hidden: less than two caps.
constexpr double strip_cost = 0.6;
// A strip is crossed by at most so many others.
constexpr int most_crossings = 1;

/// One side of what may be a strip.
struct Side {
  Index candidate = 0;
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  Vec2 direction = Vec2::Zero();
  int surface = 0;              ///< on its left (+1) or right (-1), 0 not known
  std::array<Index, 2> ends{};  ///< of the junctions
};

struct Strip {
  Side first;
  Side second;
};

class StripSearch {
 public:
  StripSearch(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
              const std::vector<int>& side)
      : lines_(lines), junctions_(junctions), ends_(ends), side_(side) {}

  void favour(std::vector<CompletionCandidate>& candidates) const {
    std::vector<Side> sides;
    for (Index c = 0; c < candidates.size(); ++c) add_side(candidates[c], c, sides);
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = i + 1; k < sides.size(); ++k) {
        const double width = even_width(sides[i], sides[k]);
        if (width > 0 && drawn_straight(sides[i], width) && drawn_straight(sides[k], width))
          strips.push_back({sides[i], sides[k]});
      }
    }
    std::vector<char> favoured(candidates.size(), 0);
    for (const Strip& strip : strips) {
      const auto crossed = std::count_if(strips.begin(), strips.end(), [&](const Strip& other) {
        return cross_properly(strip.first.from, strip.first.to, other.first.from, other.first.to);
      });
      if (crossed > most_crossings) continue;
      favoured[strip.first.candidate] = favoured[strip.second.candidate] = 1;
    }
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (favoured[c]) candidates[c].cost = std::min(strip_share * candidates[c].cost, strip_cost);
    }
  }

 private:
  void add_side(const CompletionCandidate& candidate, Index index, std::vector<Side>& sides) const {
    const int surface = side_[candidate.a] != 0 ? side_[candidate.a] : -side_[candidate.b];
    if (candidate.given != no_index || side_[candidate.a] * side_[candidate.b] > 0) return;
    const HiddenEnd& a = junctions_.ends[ends_[candidate.a]];
    const HiddenEnd& b = junctions_.ends[ends_[candidate.b]];
    Side side{index,   lines_[a.line].end(a.at_start),          lines_[b.line].end(b.at_start), Vec2::Zero(),
              surface, {ends_[candidate.a], ends_[candidate.b]}};
    side.direction = (side.to - side.from).normalized();
    if (a.tangent.dot(side.direction) < straight_cosine || -b.tangent.dot(side.direction) < straight_cosine) return;
    sides.push_back(side);
  }

  /// The width of the strip that two sides bound, 0 when that isn't even or wider than long.
  static double even_width(const Side& one, Side other) {
    if (one.direction.dot(other.direction) < 0) {
      std::swap(other.from, other.to);
      other.direction = -other.direction;
      other.surface = -other.surface;
    }
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

  /// Whether what is seen of a side is straight for as long as the strip is wide: the arms of a character are not.
  bool drawn_straight(const Side& side, double width) const {
    const HiddenEnd& a = junctions_.ends[side.ends[0]];
    const HiddenEnd& b = junctions_.ends[side.ends[1]];
    return end_chord(lines_[a.line].points, a.at_start, width).dot(side.direction) > drawn_cosine &&
           -end_chord(lines_[b.line].points, b.at_start, width).dot(side.direction) > drawn_cosine;
  }

  const std::vector<CleanLine>& lines_;
  const Junctions& junctions_;
  const std::vector<Index>& ends_;
  const std::vector<int>& side_;
};

}  // namespace

void favour_strips(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
                   const std::vector<int>& side, std::vector<CompletionCandidate>& candidates) {
  StripSearch(lines, junctions, ends, side).favour(candidates);
}

}  // namespace croquis::silhouette
