// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/level_geometry.h"

#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_tags.h"

namespace croquis::subdivision {

Vec3 unit_or_zero(const Vec3& vector) {
  constexpr double shortest = 1e-150;  // below, the square is no longer a normal number
  const double length = vector.norm();
  return length > shortest ? Vec3(vector / length) : Vec3(Vec3::Zero());
}

std::vector<double> edge_sharpness(const Level& level) {
  std::vector<double> sharpness(level.topology.edge_count(), 0);
  for (const SharpEdge& sharp : level.sharp) sharpness[sharp.edge] = sharp.sharpness;
  for (const Index corner : level.boundary) sharpness[level.topology.corner_edge[corner]] = infinite_sharpness;
  return sharpness;
}

}  // namespace croquis::subdivision
