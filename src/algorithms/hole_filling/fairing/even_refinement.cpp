// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/even_refinement.h"

#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/hole_filling/fairing/patch_editing.h"

namespace croquis::hole_filling {
namespace {

constexpr int most_halvings = 16;  // each halves edges

/// Edges of one triangle alone.
std::vector<std::array<Index, 2>> boundary_of(const std::vector<Triangle>& triangles) {
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t kept = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end == i + 1) edges[kept++] = edges[i];
  }
  edges.resize(kept);
  return edges;
}

}  // namespace

std::optional<FairingResult> refine_evenly(const FairingInput& input, double coarseness) {
  const std::vector<Index> rim = vertices_of(input.patch);
  LoosePatch loose;
  loose.rim_points = rim.size();
  for (const Index v : rim) loose.points.push_back(input.points[v]);
  for (Triangle t : input.patch) {
    for (Index& v : t) v = static_cast<Index>(std::lower_bound(rim.begin(), rim.end(), v) - rim.begin());
    loose.triangles.push_back(t);
  }
  loose.sizes = mean_lengths(loose.points, boundary_of(loose.triangles));
  for (double& size : loose.sizes) size *= coarseness;
  for (int round = 0; round < most_halvings; ++round) {
    const std::size_t before = loose.points.size();
    if (!bring_to_size(loose)) return std::nullopt;
    if (loose.points.size() <= before) break;
  }
  FairingResult refined;
  refined.new_points.assign(loose.points.begin() + static_cast<std::ptrdiff_t>(rim.size()), loose.points.end());
  const auto first_new = static_cast<Index>(input.points.size());
  for (Triangle t : loose.triangles) {
    for (Index& v : t) v = v < rim.size() ? rim[v] : first_new + (v - static_cast<Index>(rim.size()));
    refined.patch.push_back(t);
  }
  return refined;
}

}  // namespace croquis::hole_filling
