// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <ranges>
#include <span>

#include "croquis/geometry/polyline.h"
#include "io/tracing/tracing.h"

namespace croquis::tracing {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double most_turn = 80 * degree;  // of a line that goes on at a node where others end
constexpr double gap_turn = 35 * degree;   // of a line on either side of a gap
constexpr double sight = 6;                // half widths over which the direction of an end is taken
constexpr double widest_gap = 3;           // half widths, or
constexpr double least_gap = 3.5;          // pixels, if that is more
constexpr std::size_t most_ends = 40;      // at a node whose lines can be distinguished
constexpr double blurred = 1.2;            // half widths around a node within which thinning bends lines

/// An end of a branch and how the branch leaves there.
struct BranchEnd {
  Vec2 place = Vec2::Zero();      ///< pixels, where thinning doesn't bend it any more
  Vec2 direction = Vec2::Zero();  ///< unit, out of the branch
};

/// The points of a branch in the order in which one comes in at an end.
std::vector<Vec2> points_from(const Branch& branch, Index end) {
  std::vector<Vec2> points = branch.points;
  if (end % 2 != 0) std::ranges::reverse(points);
  return points;
}

/// Directions are those of the part between `skipped` and `skipped + reach` of the way into the branch.
BranchEnd leave(const Branch& branch, Index end, double skipped, double reach) {
  const std::vector<Vec2> points = points_from(branch, end);
  const std::vector<double> lengths = arc_lengths(points, false);
  const auto at = [&](double way) {
    const auto found = std::ranges::lower_bound(lengths, std::min(way, lengths.back()));
    return points[static_cast<std::size_t>(found - lengths.begin())];
  };
  const Vec2 near = at(std::min(skipped, lengths.back() / 2)), far = at(skipped + reach);
  return {near, (near - far).normalized()};
}

double turn_between(const Vec2& a, const Vec2& b) { return std::abs(std::atan2(cross(a, b), a.dot(b))); }

struct Match {
  double cost = 0;
  Index a = 0, b = 0;

  auto operator<=>(const Match&) const = default;
};

class Joining {
 public:
  Joining(const Skeleton& skeleton, double half_width)
      : skeleton_(skeleton), half_width_(half_width), at_nodes_(ends_at_nodes(skeleton)) {
    partner_.assign(2 * skeleton.branches.size(), no_index);
    leaving_.resize(partner_.size());
  }

  std::vector<TracedLine> run() {
    match_at_nodes();
    match_across_gaps();
    std::vector<TracedLine> lines;
    done_.assign(skeleton_.branches.size(), false);
    for (Index end = 0; end < partner_.size(); ++end) {
      if (partner_[end] == no_index && !done_[end / 2]) lines.push_back(line_from(end));
    }
    for (Index end = 0; end < partner_.size(); end += 2) {
      if (!done_[end / 2]) lines.push_back(line_from(end));
    }
    return lines;
  }

 private:
  const Branch& branch_of(Index end) const { return skeleton_.branches[end / 2]; }
  Index node_of(Index end) const { return branch_of(end).nodes[end % 2]; }

  void match(std::vector<Match> matches) {
    std::ranges::sort(matches);
    for (const auto& [cost, a, b] : matches) {
      if (partner_[a] != no_index || partner_[b] != no_index) continue;
      partner_[a] = b;
      partner_[b] = a;
    }
  }

  void match_at_nodes() {
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      const std::vector<Index>& ends = at_nodes_[node];
      const double skipped = blurred * skeleton_.nodes[node].half_width;
      for (const Index end : ends) leaving_[end] = leave(branch_of(end), end, skipped, sight * half_width_);
      if (ends.size() > most_ends) continue;
      std::vector<Match> matches;
      for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const double turn = turn_between(leaving_[ends[i]].direction, -leaving_[ends[j]].direction);
          if (ends.size() == 2 || turn < most_turn) matches.push_back({turn, ends[j], ends[i]});
        }
      }
      match(std::move(matches));
    }
  }

  /// Where a line that ends at a node meets one that goes through it; else the node.
  Vec2 meeting_place(Index end) const {
    const SkeletonNode& node = skeleton_.nodes[node_of(end)];
    const BranchEnd& stem = leaving_[end];
    Vec2 nearest = node.place;
    double least = 3 * node.half_width;
    for (const Index other : at_nodes_[node_of(end)]) {
      if (partner_[other] == no_index || node_of(partner_[other]) != node_of(end)) continue;
      const Vec2 bar = leaving_[partner_[other]].place - leaving_[other].place;
      const double sine = cross(stem.direction, bar);
      if (std::abs(sine) < 0.2 * bar.norm()) continue;
      const double way = cross(leaving_[other].place - stem.place, bar) / sine;
      const Vec2 place = stem.place + way * stem.direction;
      if (way < 0 || (place - node.place).norm() > least) continue;
      nearest = place;
      least = (place - node.place).norm();
    }
    return nearest;
  }

  /// Ends that are free of all others, from left to right.
  std::vector<std::pair<BranchEnd, Index>> free_ends() const {
    std::vector<std::pair<BranchEnd, Index>> ends;
    for (Index end = 0; end < partner_.size(); ++end) {
      if (branch_of(end).closed || partner_[end] != no_index) continue;
      if (node_of(end) != no_index && at_nodes_[node_of(end)].size() > 1) continue;
      ends.emplace_back(leave(branch_of(end), end, 0, sight * half_width_), end);
    }
    std::ranges::sort(ends, {}, [](const auto& end) { return end.first.place.x(); });
    return ends;
  }

  void match_across_gaps() {
    const double widest = std::max(widest_gap * half_width_, least_gap);
    const auto ends = free_ends();
    std::vector<Match> matches;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const auto& [a, first] = ends[i];
        const auto& [b, second] = ends[j];
        const Vec2 gap = b.place - a.place;
        if (gap.x() > widest) break;
        if (gap.norm() > widest || turn_between(a.direction, -b.direction) > 2 * gap_turn) continue;
        // Over so little the direction of the gap says nothing.
        const bool is_short = gap.norm() < 2;
        const double aside = std::max(turn_between(a.direction, gap), turn_between(b.direction, -gap));
        if (is_short || aside < gap_turn) matches.push_back({gap.norm(), first, second});
      }
    }
    match(std::move(matches));
  }

  /// Adds a branch as seen from the end at which the line comes in.
  void add_branch(TracedLine& line, Index end) {
    done_[end / 2] = true;
    const double length_of = length(branch_of(end).points, false);
    for (const Vec2& point : points_from(branch_of(end), end)) {
      const auto is_blurred = [&](Index at) {
        if (node_of(at) == no_index || at_nodes_[node_of(at)].size() < 3) return false;
        const SkeletonNode& node = skeleton_.nodes[node_of(at)];
        return (point - node.place).norm() < std::min(blurred * node.half_width, length_of / 3);
      };
      if (!is_blurred(end) && !is_blurred(end ^ 1U)) line.points.push_back(point);
    }
  }

  /// Where a line bends at a node, and where it ends there, it goes through it.
  void add_node(TracedLine& line, Index end) const {
    if (node_of(end) == no_index) return;
    const bool goes_on = partner_[end] != no_index && at_nodes_[node_of(end)].size() > 2;
    if (!goes_on) line.points.push_back(meeting_place(end));
  }

  TracedLine line_from(Index first) {
    TracedLine line;
    line.closed = branch_of(first).closed || partner_[first] != no_index;
    if (!line.closed) add_node(line, first);
    for (Index end = first; !done_[end / 2];) {
      add_branch(line, end);
      const Index out = end ^ 1U;
      add_node(line, out);
      if (partner_[out] == no_index) break;
      end = partner_[out];
    }
    return line;
  }

  const Skeleton& skeleton_;
  double half_width_;
  std::vector<std::vector<Index>> at_nodes_;
  std::vector<Index> partner_;
  std::vector<BranchEnd> leaving_;  ///< by end, of those at nodes
  std::vector<bool> done_;
};

}  // namespace

std::vector<TracedLine> joined_lines(const Skeleton& skeleton, double half_width) {
  return Joining(skeleton, half_width).run();
}

}  // namespace croquis::tracing
