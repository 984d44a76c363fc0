// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/depth_guard.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/skeleton/overlap_cycles.h"

namespace croquis::silhouette {
namespace {

/// The most that the depths along one chain of objects, each over the next, add up to.
double longest_chain(const std::vector<std::vector<Index>>& below, const std::vector<double>& depths) {
  const OverlapCycles cycles = overlap_cycles(below);
  std::vector<std::vector<Index>> members(cycles.count);
  for (Index object = 0; object < depths.size(); ++object) members[cycles.cycle[object]].push_back(object);
  std::vector<double> chains;  // per cycle the longest one from it downwards
  for (Index cycle = 0; cycle < cycles.count; ++cycle) {
    double own = 0;
    double most_below = 0;
    for (const Index member : members[cycle]) {
      own += depths[member];
      for (const Index lower : below[member]) {
        if (cycles.cycle[lower] != cycle) most_below = std::max(most_below, chains[cycles.cycle[lower]]);
      }
    }
    chains.push_back(own + most_below);
  }
  return chains.empty() ? 0 : *std::max_element(chains.begin(), chains.end());
}

}  // namespace

double explained_depth(const LabelledFigure& figure, const Skeleton& skeleton, double gap,
                       const std::vector<double>& thickness) {
  std::vector<double> widths(figure.objects.size(), 0);
  for (const SkeletonNode& node : skeleton.nodes) widths[node.object] = std::max(widths[node.object], 2 * node.radius);
  for (std::size_t object = 0; object < std::min(widths.size(), thickness.size()); ++object) {
    widths[object] *= thickness[object];
  }
  std::vector<double> depths(figure.objects.size());
  for (Index object = 0; object < depths.size(); ++object) depths[object] = widths[object] + gap;
  std::vector<std::vector<Index>> below(depths.size());
  for (const FigureOverlap& overlap : figure.overlaps) {
    if (overlap.upper == overlap.lower) {
      depths[overlap.upper] += widths[overlap.upper] + gap;
    } else {
      below[overlap.upper].push_back(overlap.lower);
    }
  }
  return longest_chain(below, depths);
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
