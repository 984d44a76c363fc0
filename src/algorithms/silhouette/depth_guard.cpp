// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/depth_guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis::silhouette {
namespace {

/// Objects and what lies directly below them, cut into cycles (strongly connected components, Tarjan 1972).
class OverlapChains {
 public:
  OverlapChains(const LabelledFigure& figure, std::vector<double> depths)
      : depths_(std::move(depths)),
        below_(depths_.size()),
        number_(depths_.size(), no_index),
        lowest_(depths_.size(), no_index),
        circle_(depths_.size(), no_index) {
    for (const FigureOverlap& overlap : figure.overlaps) {
      if (overlap.upper != overlap.lower) below_[overlap.upper].push_back(overlap.lower);
    }
  }

  /// The most that the depths along one chain add up to.
  double longest() {
    for (Index object = 0; object < depths_.size(); ++object) {
      if (number_[object] == no_index) visit(object);
    }
    return chains_.empty() ? 0 : *std::max_element(chains_.begin(), chains_.end());
  }

 private:
  struct Visit {
    Index object = 0;
    std::size_t next = 0;  ///< of what lies below it
  };

  void visit(Index first) {
    std::vector<Visit> path{enter(first)};
    while (!path.empty()) {
      Visit& here = path.back();
      if (here.next < below_[here.object].size()) {
        const Index lower = below_[here.object][here.next++];
        if (number_[lower] == no_index) {
          path.push_back(enter(lower));
        } else if (circle_[lower] == no_index) {
          lowest_[here.object] = std::min(lowest_[here.object], number_[lower]);
        }
        continue;
      }
      const Index done = here.object;
      path.pop_back();
      if (!path.empty()) lowest_[path.back().object] = std::min(lowest_[path.back().object], lowest_[done]);
      if (lowest_[done] == number_[done]) close_circle(done);
    }
  }

  Visit enter(Index object) {
    number_[object] = lowest_[object] = entered_++;
    open_.push_back(object);
    return {object, 0};
  }

  /// All that lies below a cycle has been closed before.
  void close_circle(Index first) {
    std::vector<Index> members;
    do {
      members.push_back(open_.back());
      open_.pop_back();
      circle_[members.back()] = static_cast<Index>(chains_.size());
    } while (members.back() != first);
    double own = 0;
    double most_below = 0;
    for (const Index member : members) {
      own += depths_[member];
      for (const Index lower : below_[member]) {
        if (circle_[lower] < chains_.size()) most_below = std::max(most_below, chains_[circle_[lower]]);
      }
    }
    chains_.push_back(own + most_below);
  }

  std::vector<double> depths_;
  std::vector<std::vector<Index>> below_;
  std::vector<Index> number_;
  std::vector<Index> lowest_;
  std::vector<Index> circle_;   ///< per object, once closed
  std::vector<Index> open_;     ///< entered, in no cycle yet
  std::vector<double> chains_;  ///< per cycle the longest chain from it downwards
  Index entered_ = 0;
};

}  // namespace

double explained_depth(const LabelledFigure& figure, const Skeleton& skeleton, double gap) {
  std::vector<double> widths(figure.objects.size(), 0);
  for (const SkeletonNode& node : skeleton.nodes) widths[node.object] = std::max(widths[node.object], 2 * node.radius);
  std::vector<double> depths(figure.objects.size());
  for (Index object = 0; object < depths.size(); ++object) depths[object] = widths[object] + gap;
  for (const FigureOverlap& overlap : figure.overlaps) {
    if (overlap.upper == overlap.lower) depths[overlap.upper] += widths[overlap.upper] + gap;
  }
  return OverlapChains(figure, std::move(depths)).longest();
}

std::vector<Index> objects_too_deep(std::vector<DepthRange> ranges, double most) {
  const auto reach = [](const DepthRange& range) { return std::max(std::abs(range.low), std::abs(range.high)); };
  std::vector<Index> refused;
  while (!ranges.empty()) {
    double low = ranges.front().low;
    double high = ranges.front().high;
    for (const DepthRange& range : ranges) {
      low = std::min(low, range.low);
      high = std::max(high, range.high);
    }
    const auto farthest = std::max_element(
        ranges.begin(), ranges.end(), [&](const DepthRange& a, const DepthRange& b) { return reach(a) < reach(b); });
    if (high - low <= most) break;
    refused.push_back(farthest->object);
    ranges.erase(farthest);
  }
  std::sort(refused.begin(), refused.end());
  return refused;
}

}  // namespace croquis::silhouette
