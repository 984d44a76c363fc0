// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/patch_relaxation.h"

#include <Eigen/Geometry>

namespace croquis::hole_filling {

void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed) {
  std::vector<Vec3> sums(patch.points.size(), Vec3::Zero());  // of weight times the vector to the triangle's centroid
  std::vector<double> weights(patch.points.size(), 0);
  for (const auto& t : patch.triangles) {
    const Vec3 ab = patch.points[t[1]] - patch.points[t[0]], ac = patch.points[t[2]] - patch.points[t[0]];
    const double size = patch.sizes[t[0]] + patch.sizes[t[1]] + patch.sizes[t[2]];
    const double weight = ab.cross(ac).norm() / size;  // but for a common factor
    const Vec3 middle = (ab + ac) / 3;                 // from a, for the digits of patches far away
    sums[t[0]] += weight * middle;
    sums[t[1]] += weight * (middle - ab);
    sums[t[2]] += weight * (middle - ac);
    for (const Index v : t) weights[v] += weight;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (fixed[v] == 0 && weights[v] > 0) patch.points[v] += sums[v] / weights[v];
  }
}

}  // namespace croquis::hole_filling
