// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/rim_crossing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/patching/near_scene.h"

namespace croquis::hole_filling {
namespace {

/// More than rounding makes of a determinant, × the product of its edges.
constexpr double rounding = 1e-14;

/// The side of the plane through a, b and c that d is on: 1, -1, or 0 where rounding might decide.
int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  const double volume = ab.cross(ac).dot(ad), doubt = rounding * ab.norm() * ac.norm() * ad.norm();
  return volume > doubt ? 1 : volume < -doubt ? -1 : 0;
}

/// Whether the line from p to q goes through the inside of the triangle.
bool goes_through(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (side_of(a, b, c, p) * side_of(a, b, c, q) >= 0) return false;
  const int turn = side_of(p, q, a, b);
  return turn != 0 && turn == side_of(p, q, b, c) && turn == side_of(p, q, c, a);
}

}  // namespace

bool rims_cross_surface(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  const std::vector<Vec3>& at = site.mesh->positions;
  const SurfaceSearch own(*site.mesh, view);
  const SurfaceSearch& search = site.search == nullptr ? own : *site.search;
  for (Index point = 0; point < site.vertices.size(); ++point) {
    const Index from = view.representative_of(site.vertices[point]);
    const Index to = view.representative_of(site.vertices[site.polygon.next(point)]);
    const Vec3 &p = at[from], &q = at[to];
    const auto crosses = [&](Index triangle) {
      const auto& t = view.triangles[triangle];
      if (std::ranges::any_of(t, [&](Index v) { return v == from || v == to; })) return false;
      return goes_through(p, q, at[t[0]], at[t[1]], at[t[2]]);
    };
    if (std::ranges::any_of(search.near({p.cwiseMin(q), p.cwiseMax(q)}), crosses)) return true;
  }
  return false;
}

}  // namespace croquis::hole_filling
