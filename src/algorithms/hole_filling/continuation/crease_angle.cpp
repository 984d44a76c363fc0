// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/crease_angle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/patching/site_memory.h"

namespace croquis::hole_filling {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double least_crease = 12 * radians, most_crease = 35 * radians;
constexpr double crease_factor = 4;  // × the angle of usual edges
constexpr double usual_share = 0.8;  // of edges: creases that pass are fewer than the others
constexpr int looked_rings = 3;

/// Falls as the angle grows, and takes a fraction of its time.
double cotangent_between(const Vec3& a, const Vec3& b) {
  const double along = a.dot(b), across = a.cross(b).norm();
  if (across > 0) return along / across;
  return along < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

double found_crease_cosine(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  std::vector<double> cotangents;
  for (const Index triangle : surroundings(site, looked_rings)) {
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
      const Index other = view.opposite[corner];
      if (view.has_opposite(corner) && corner < other)
        cotangents.push_back(cotangent_between(triangle_normal(site, triangle), triangle_normal(site, other / 3)));
    }
  }
  if (cotangents.empty()) return std::cos(most_crease);
  const auto usual =
      cotangents.begin() + static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(cotangents.size() - 1));
  std::nth_element(cotangents.begin(), usual, cotangents.end(), std::greater());
  const double usual_angle = std::atan2(1.0, *usual);
  return std::cos(std::clamp(crease_factor * usual_angle, least_crease, most_crease));
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
