// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/verification/rim_edges.h"

#include <algorithm>
#include <cstdint>

namespace croquis::hole_filling {

std::vector<std::array<Index, 2>> edges_between_rims(const PolyMesh& mesh, const HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  std::vector<std::uint8_t> on_rim(mesh.vertex_count(), 0);
  for (const Hole& hole : analysis.holes) {
    for (const Index vertex : hole.vertices) on_rim[view.representative_of(vertex)] = 1;
  }
  std::vector<std::array<Index, 2>> edges;
  for (const auto& t : view.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
      if (on_rim[low] != 0 && on_rim[high] != 0) edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace croquis::hole_filling
