// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/crease_angle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/patching/site_memory.h"
#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double least_crease = 12 * radians, most_crease = 35 * radians;
constexpr double crease_factor = 4;  // × the angle of usual edges
constexpr double usual_share = 0.8;  // of edges: creases that pass are fewer than the others
constexpr int looked_rings = 3;

double found_crease_cosine(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  std::vector<double> angles;
  for (const Index triangle : surroundings(site, looked_rings)) {
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
      if (view.has_opposite(corner) && corner < view.opposite[corner])
        angles.push_back(
            angle_between(triangle_normal(site, triangle), triangle_normal(site, view.opposite[corner] / 3)));
    }
  }
  if (angles.empty()) return std::cos(most_crease);
  const auto usual = angles.begin() + static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(angles.size() - 1));
  std::nth_element(angles.begin(), usual, angles.end());
  return std::cos(std::clamp(crease_factor * *usual, least_crease, most_crease));
}

}  // namespace

double crease_cosine(const HoleSite& site) {
  if (site.memory == nullptr) return found_crease_cosine(site);
  std::optional<double>& known = site.memory->crease_cosine;
  if (!known) known = found_crease_cosine(site);
  return *known;
}

bool is_smooth(const Vec3& normal, const Vec3& other, double crease_cosine) {
  return normal.dot(other) >= crease_cosine * normal.norm() * other.norm();
}

}  // namespace croquis::hole_filling
