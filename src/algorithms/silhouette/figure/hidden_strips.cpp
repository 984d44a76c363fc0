// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/hidden_strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  double facing = 1;            ///< cosine between it and the worse of its two ends
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
        if (fits(strip)) strips.push_back(strip);
      }
    }
    return strips;
  }

  void add_side(const CompletionCandidate& candidate, Index index, std::vector<Side>& sides) const {
    const int surface = side_[candidate.a] != 0 ? side_[candidate.a] : -side_[candidate.b];
    if (candidate.given != no_index || side_[candidate.a] * side_[candidate.b] > 0) return;
    const HiddenEnd& a = junctions_.ends[ends_[candidate.a]];
    const HiddenEnd& b = junctions_.ends[ends_[candidate.b]];
    Side side{index,   lines_[a.line].end(a.at_start),          lines_[b.line].end(b.at_start), Vec2::Zero(), 1,
              surface, {ends_[candidate.a], ends_[candidate.b]}};
    side.direction = (side.to - side.from).normalized();
    side.facing = std::min(a.tangent.dot(side.direction), -b.tangent.dot(side.direction));
    if (side.facing >= strand_fit.side_cosine) sides.push_back(side);
  }

  /// Of a strip at its narrower and at its wider end.
  struct Widths {
    double least = 0;
    double most = 0;
  };

  /// Not positive when the two sides don't bound a strip.
  static Widths widths(const Strip& strip) {
    const Side& one = strip.first;
    const Side& other = strip.second;
    if (one.surface * other.surface > 0) return {};
    int between = one.surface != 0 ? one.surface : -other.surface;
    if (between == 0) between = cross(one.direction, other.from - one.from) > 0 ? 1 : -1;
    const double begin = between * cross(one.direction, other.from - one.from);
    const double end = between * cross(one.direction, other.to - one.to);
    return {std::min(begin, end), std::max(begin, end)};
  }

  bool fits(const Strip& strip) const {
    const Widths width = widths(strip);
    if (width.least <= 0) return false;
    const double length = (strip.first.to - strip.first.from).norm();
    if (fits(strip, width, length, strip_fit)) return true;
    return junctions_.tremble > 0 && length < most_length_behind_strand * width.most && is_strand(strip, length) &&
           fits(strip, width, length, strand_fit);
  }

  bool fits(const Strip& strip, const Widths& width, double length, const StripFit& fit) const {
    const Side& one = strip.first;
    const Side& other = strip.second;
    const bool beside = std::abs(one.direction.dot(other.from - one.from)) < width.most + 0.5 * length;
    return std::min(one.facing, other.facing) >= fit.side_cosine &&
           one.direction.dot(other.direction) >= fit.parallel_cosine &&
           width.least > (1 - fit.most_taper) * width.most && length > fit.least_length * width.most && beside &&
           goes_on(strip, width.most, fit.strip_cosine);
  }

  /// Whether it may be a strand behind a strand: both sides go in behind one line, come out behind one line that runs
  /// the other way, and what lies between is narrow beside them. A limb, which ends twice at its body, has both of its
  /// own sides.
  bool is_strand(const Strip& strip, double length) const {
    std::array<Vec2, 2> along;  // of what covers it, with its surface on the left
    for (const std::size_t at : {0U, 1U}) {
      const HiddenEnd& one = junctions_.ends[strip.first.ends[at]];
      const HiddenEnd& other = junctions_.ends[strip.second.ends[at]];
      if (one.bar != other.bar || length > most_share_of_bar * lines_[one.bar].size) return false;
      if (one.line != other.line && (bodies_[one.line] != no_index || bodies_[other.line] != no_index)) return false;
      along[at] = (bar_direction(one) + bar_direction(other)).normalized();
    }
    return along[0].dot(along[1]) < opposite_cosine;
  }

  Vec2 bar_direction(const HiddenEnd& end) const {
    const CleanLine& bar = lines_[end.bar];
    const Index last = bar.segment_count();
    const double reach = std::min(bar_steps, last / 4.0);
    const auto place = [&](double parameter) {
      return point_at(bar.points,
                      bar.closed ? std::fmod(parameter + last, last) : std::clamp<double>(parameter, 0, last));
    };
    return end.bar_side * (place(end.bar_parameter + reach) - place(end.bar_parameter - reach)).normalized();
  }

  /// Whether what is seen of it goes straight on, for as long as the strip is wide: the arms of a character don't.
  bool goes_on(const Strip& strip, double width, double least_cosine) const {
    const Vec2 along =
        (0.5 * (strip.first.to + strip.second.to) - 0.5 * (strip.first.from + strip.second.from)).normalized();
    for (const std::size_t at : {0U, 1U}) {
      const Vec2 outward = (chord(strip.first.ends[at], width) + chord(strip.second.ends[at], width)).normalized();
      if ((at == 0 ? 1 : -1) * outward.dot(along) < least_cosine) return false;
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
