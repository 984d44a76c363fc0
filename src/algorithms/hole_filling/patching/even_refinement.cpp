// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/even_refinement.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "algorithms/hole_filling/patching/patch_editing.h"

namespace croquis::hole_filling {
namespace {

constexpr int most_rounds = 16;  // each halves edges

std::vector<Index> vertices_of(const std::vector<Triangle>& triangles) {
  std::vector<Index> vertices;
  for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Mean length of the boundary's edges at each point.
std::vector<double> boundary_sizes(const LoosePatch& loose) {
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : loose.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<double> sums(loose.points.size(), 0), counts(loose.points.size(), 0);
  for (std::size_t i = 0; i < edges.size();) {
    const auto& edge = edges[i];
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end] == edge) ++end;
    if (end == i + 1) {
      const double length = (loose.points[edge.first] - loose.points[edge.second]).norm();
      for (const Index v : {edge.first, edge.second}) {
        sums[v] += length;
        counts[v] += 1;
      }
    }
    i = end;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (counts[v] > 0) sums[v] /= counts[v];
  }
  return sums;
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
  loose.sizes = boundary_sizes(loose);
  for (double& size : loose.sizes) size *= coarseness;
  for (int round = 0; round < most_rounds; ++round) {
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
