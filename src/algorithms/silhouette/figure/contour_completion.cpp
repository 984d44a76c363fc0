// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/contour_completion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/silhouette/figure/hidden_caps.h"
#include "algorithms/silhouette/figure/hidden_strips.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// Midpoint rule over so many pieces: the bending of a half circle is right to 0.1 %.
constexpr int integration_pieces = 24;
// Bending away from the surface costs this much more than bending round it.
constexpr double concave_factor = 5;

// What is missing in front of a piece, in terms of cost: a covered piece is preferred to one that lies in the open
// unless that is very much shorter.
constexpr double bare_cost = 3;
// Joining two lines that go round something on opposite sides costs so much more.
constexpr double disagreement_cost = 15;
// So many candidates of an end are judged by what covers them.
constexpr std::size_t judged_candidates = 8;
// A piece is judged by so many chords.
constexpr int judged_pieces = 20;

struct Derivatives {
  Vec2 first;
  Vec2 second;
};

Derivatives derivatives_at(const std::array<Vec2, 4>& p, double t) {
  const double s = 1 - t;
  return {3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2])),
          6 * (s * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]))};
}

bool may_join(const std::vector<CleanLine>& lines, const Junctions& junctions, const HiddenEnd& a, const HiddenEnd& b) {
  const std::string& first = lines[a.line].object;
  const std::string& second = lines[b.line].object;
  if (!first.empty() && !second.empty() && first != second) return false;
  const int side_a = outward_side(junctions, a);
  const int side_b = -outward_side(junctions, b);
  return side_a == 0 || side_b == 0 || side_a == side_b;
}

/// Per end: the known piece that it belongs to.
std::vector<Index> given_pieces_of(const Junctions& junctions) {
  std::vector<Index> piece(junctions.ends.size(), no_index);
  for (Index k = 0; k < junctions.given.size(); ++k) {
    piece[junctions.given[k].from] = k;
    piece[junctions.given[k].to] = k;
  }
  return piece;
}

}  // namespace

bool CompletionJudge::judge(CompletionCandidate& candidate) const {
  if (candidate.judged || candidate.given != no_index) return false;
  candidate.judged = true;
  std::array<double, completion_shapes.size()> price{};
  for (Index shape = 0; shape < price.size(); ++shape) {
    price[shape] = bare_cost * cover_.missing(shaped_chords(candidate.bezier, completion_shapes[shape], judged_pieces));
    if (shape == 0 && price[shape] <= 0) return false;
  }
  std::stable_sort(candidate.shapes.begin(), candidate.shapes.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return price[a] < price[b]; });
  const double before = candidate.cost;
  const double least = price[candidate.shapes.front()];
  candidate.cost = strip_cost(candidate.plain_cost + least, candidate.strip_factor);
  if (least > 0 && candidate.one_bar) candidate.shapes.insert(candidate.shapes.begin(), kept_behind_shape);
  return candidate.cost > before;
}

std::vector<Index> likely_candidates(std::size_t ends, const std::vector<CompletionCandidate>& candidates) {
  std::vector<std::vector<Index>> of_end(ends);
  for (Index c = 0; c < candidates.size(); ++c) {
    if (candidates[c].given != no_index) continue;
    of_end[candidates[c].a].push_back(c);
    of_end[candidates[c].b].push_back(c);
  }
  std::vector<Index> likely;
  for (std::vector<Index>& own : of_end) {
    const auto last = own.begin() + static_cast<std::ptrdiff_t>(std::min(own.size(), judged_candidates));
    std::partial_sort(own.begin(), last, own.end(), [&](Index a, Index b) {
      return std::pair(candidates[a].cost, a) < std::pair(candidates[b].cost, b);
    });
    likely.insert(likely.end(), own.begin(), last);
  }
  std::sort(likely.begin(), likely.end());
  likely.erase(std::unique(likely.begin(), likely.end()), likely.end());
  return likely;
}

double completion_cost(const std::array<Vec2, 4>& curve, int side, double reference, const CompletionOptions& options) {
  double length = 0;
  double bending = 0;
  for (int i = 0; i < integration_pieces; ++i) {
    const Derivatives d = derivatives_at(curve, (i + 0.5) / integration_pieces);
    const double speed = d.first.norm();
    if (!(speed > 0)) return std::numeric_limits<double>::infinity();
    length += speed / integration_pieces;
    const double turn = cross(d.first, d.second);
    const double factor = turn * side < 0 ? concave_factor : 1;
    bending += factor * turn * turn / (speed * speed * speed * speed * speed) / integration_pieces;
  }
  return options.length_weight * length / reference + options.curvature_weight * (curve[3] - curve[0]).norm() * bending;
}

double completion_reference(const std::vector<CleanLine>& lines, const Junctions& junctions) {
  std::vector<Vec2> places;
  const std::vector<Index> given = given_pieces_of(junctions);
  for (Index e = 0; e < junctions.ends.size(); ++e) {
    const HiddenEnd& end = junctions.ends[e];
    if (given[e] == no_index) places.push_back(lines[end.line].end(end.at_start));
  }
  std::vector<double> nearest(places.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double distance = (places[k] - places[i]).norm();
      nearest[i] = std::min(nearest[i], distance);
      nearest[k] = std::min(nearest[k], distance);
    }
  }
  if (nearest.empty()) return 0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

std::vector<CompletionCandidate> completion_candidates(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                                       const std::vector<Index>& ends, double reference,
                                                       const CompletionOptions& options) {
  std::vector<CompletionCandidate> candidates;
  const std::vector<Index> given = given_pieces_of(junctions);
  const HiddenCaps caps(lines, junctions);
  std::vector<int> side;
  side.reserve(ends.size());
  for (const Index end : ends) side.push_back(caps.outward_side(junctions.ends[end]));
  for (Index i = 0; i < ends.size(); ++i) {
    for (Index k = i + 1; k < ends.size(); ++k) {
      const HiddenEnd& a = junctions.ends[ends[i]];
      const HiddenEnd& b = junctions.ends[ends[k]];
      if (given[ends[i]] != given[ends[k]]) continue;
      if (given[ends[i]] != no_index) {
        CompletionCandidate known;
        known.a = i;
        known.b = k;
        known.given = given[ends[i]];
        candidates.push_back(known);
        continue;
      }
      if (!(reference > 0) || !may_join(lines, junctions, a, b)) continue;
      const Vec2& from = lines[a.line].end(a.at_start);
      const Vec2& to = lines[b.line].end(b.at_start);
      // No curve is shorter than its chord.
      if (options.length_weight * (to - from).norm() > options.maximum_cost * reference) continue;
      CompletionCandidate candidate;
      candidate.a = i;
      candidate.b = k;
      candidate.one_bar = a.bar == b.bar && a.bar_side == b.bar_side;
      candidate.bezier = completion_curve(from, a.tangent, to, b.tangent);
      const int agreed = side[i] == -side[k] ? side[i] : 0;
      candidate.plain_cost = completion_cost(candidate.bezier, agreed, reference, options);
      if (agreed == 0)
        candidate.plain_cost += disagreement_cost * std::min(caps.roundness(a.line), caps.roundness(b.line));
      candidate.plain_cost = std::min(candidate.plain_cost, caps.highest_cost(a, b, candidate.bezier));
      if (candidate.plain_cost > options.maximum_cost) continue;
      candidates.push_back(candidate);
    }
  }
  // A straight line goes round neither of its sides.
  for (Index i = 0; i < ends.size(); ++i) {
    const HiddenEnd& end = junctions.ends[ends[i]];
    if (outward_side(junctions, end) == 0 && caps.roundness(end.line) <= 0) side[i] = 0;
  }
  favour_strips(lines, junctions, ends, side, candidates);
  for (CompletionCandidate& candidate : candidates) {
    candidate.cost = strip_cost(candidate.plain_cost, candidate.strip_factor);
  }
  return candidates;
}

}  // namespace croquis::silhouette
