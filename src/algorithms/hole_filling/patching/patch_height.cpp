// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/patch_height.h"

#include <algorithm>
#include <cmath>

namespace croquis::hole_filling {
namespace {

constexpr double allowed_height = 0.5;  ///< × diameter of the hole
constexpr double allowed_growth = 1.3;  ///< × height of the faired patch

const Hole& widest_of(const HoleSite& site) {
  const auto diameter = [&](Index hole) { return site.analysis->holes[hole].diameter; };
  return site.analysis->holes[std::ranges::max(site.holes, {}, diameter)];
}

double height_of(const std::vector<Vec3>& places, const Hole& hole) {
  double height = 0;
  for (const Vec3& place : places) height = std::max(height, std::abs(hole.normal.dot(place - hole.centre)));
  return height;
}

}  // namespace

double patch_height(const HoleSite& site, const HolePatch& patch) {
  const Hole& hole = widest_of(site);
  return std::max(height_of(site.polygon.points, hole), height_of(patch.points, hole));
}

bool rises_too_far(const HoleSite& site, const HolePatch& patch, std::size_t most_triangles, Progress& progress) {
  if (site.bridge || site.wish.bulge != 0 || !site.wish.through.empty()) return false;
  const double height = patch_height(site, patch);
  const Hole& hole = widest_of(site);
  if (height <= std::max(allowed_height * hole.diameter, allowed_growth * height_of(site.polygon.points, hole)))
    return false;
  const auto faired = faired_patcher(1, most_triangles)->attempt(site, progress);
  return !faired || height > allowed_growth * patch_height(site, *faired);
}

}  // namespace croquis::hole_filling
