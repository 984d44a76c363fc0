// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/other_sheets.h"

#include <algorithm>
#include <optional>

#include <Eigen/Geometry>

#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr double sheet_spacing_growth = 1.3;

std::vector<PassingPoint> all_passing(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach) {
  const SurfaceView& view = site.analysis->view;
  const std::vector<Vec3>& positions = site.mesh->positions;
  std::vector<Index> joined;
  for (const ReachedVertex& r : reached) joined.push_back(r.vertex);
  std::sort(joined.begin(), joined.end());
  const implicit::PointTree rims(site.polygon.points);
  const implicit::Box box = implicit::bounds(site.polygon.points);
  const Vec3 low = box.low - Vec3::Constant(reach), high = box.high + Vec3::Constant(reach);
  std::vector<PassingPoint> passing;
  for (Index t = 0; t < view.triangles.size(); ++t) {
    const auto& [a, b, c] = view.triangles[t];
    const Vec3 middle = (positions[a] + positions[b] + positions[c]) / 3;
    if ((middle.array() < low.array()).any() || (middle.array() > high.array()).any() || view.flags[t] > 1) continue;
    const bool is_joined = std::any_of(view.triangles[t].begin(), view.triangles[t].end(),
                                       [&](Index v) { return std::binary_search(joined.begin(), joined.end(), v); });
    if (is_joined || (site.polygon.points[rims.nearest(middle)] - middle).norm() > reach) continue;
    passing.push_back({middle, (positions[b] - positions[a]).cross(positions[c] - positions[a]).normalized()});
  }
  return passing;
}

std::optional<std::vector<PassingPoint>> thinned(const std::vector<PassingPoint>& all, double spacing,
                                                 std::size_t most) {
  std::vector<PassingPoint> taken;
  for (const PassingPoint& point : all) {
    if (std::any_of(taken.begin(), taken.end(), [&](const PassingPoint& other) {
          return (other.position - point.position).squaredNorm() < spacing * spacing;
        }))
      continue;
    if (taken.size() == most) return std::nullopt;
    taken.push_back(point);
  }
  return taken;
}

}  // namespace

std::vector<PassingPoint> other_sheets(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach,
                                       double spacing, std::size_t most) {
  const std::vector<PassingPoint> all = all_passing(site, reached, reach);
  for (;; spacing *= sheet_spacing_growth) {
    if (auto taken = thinned(all, spacing, most)) return *taken;
  }
}

}  // namespace croquis::hole_filling
