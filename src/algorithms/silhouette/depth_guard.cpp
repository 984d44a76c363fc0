// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/depth_guard.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/silhouette/skeleton/overlap_cycles.h"

namespace croquis::silhouette {
namespace {

/// The most that the depths along one chain of objects, each over the next, add up to.
double longest_chain(const std::vector<std::vector<Index>>& below, const std::vector<double>& depths) {
  const OverlapCycles cycles = overlap_cycles(below);
  std::vector<Index> from_below(depths.size());
  std::iota(from_below.begin(), from_below.end(), Index{0});
  std::ranges::stable_sort(from_below, {}, [&](Index object) { return cycles.cycle[object]; });
  std::vector<double> own(cycles.count, 0), most_below(cycles.count, 0);
  double longest = 0;
  for (const Index object : from_below) {
    const Index cycle = cycles.cycle[object];
    own[cycle] += depths[object];
    for (const Index lower : below[object]) {
      const Index next = cycles.cycle[lower];
      if (next != cycle) most_below[cycle] = std::max(most_below[cycle], own[next] + most_below[next]);
    }
    longest = std::max(longest, own[cycle] + most_below[cycle]);
  }
  return longest;
}

}  // namespace

double explained_depth(const LabelledFigure& figure, const Skeleton& skeleton, double gap,
                       const std::vector<double>& thickness) {
  std::vector<double> widths(figure.objects.size(), 0), depths;
  for (const SkeletonNode& node : skeleton.nodes) widths[node.object] = std::max(widths[node.object], 2 * node.radius);
  for (Index object = 0; object < widths.size(); ++object) {
    if (object < thickness.size()) widths[object] *= thickness[object];
    depths.push_back(widths[object] + gap);
  }
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
    const double low = std::ranges::min_element(ranges, {}, &DepthRange::low)->low;
    const double high = std::ranges::max_element(ranges, {}, &DepthRange::high)->high;
    if (high - low <= most) break;
    const auto farthest = std::ranges::max_element(ranges, {}, reach);
    refused.push_back(farthest->object);
    ranges.erase(farthest);
  }
  std::ranges::sort(refused);
  return refused;
}

}  // namespace croquis::silhouette
