// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_confidence.h"

#include <algorithm>
#include <vector>

#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

std::vector<Vec3> edge_middles(const HolePatch& patch, const PolyMesh& mesh) {
  std::vector<Vec3> middles;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      middles.push_back(0.5 * (mesh.positions[t[i]] + mesh.positions[t[(i + 1) % 3]]));
  }
  return middles;
}

}  // namespace

double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  std::vector<Vec3> rims;
  double size = 0;
  for (const Index id : patch.holes) {
    for (const Index v : analysis.holes[id].vertices) rims.push_back(mesh.positions[v]);
    size = std::max(size, analysis.holes[id].diameter);
  }
  const implicit::PointTree tree(rims);
  double farthest = 0;
  for (const Vec3& place : patch.points.empty() ? edge_middles(patch, mesh) : patch.points)
    farthest = std::max(farthest, (place - rims[tree.nearest(place)]).norm());
  const double twice = 2 * farthest / size;
  return 1 / (1 + twice * twice * twice * twice);
}

}  // namespace croquis::hole_filling
