// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/rim_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

struct RimEdge {
  Index from, to;  ///< of the view
  Eigen::AlignedBox3d box;
};

/// By their least x, so that those near a triangle are a stretch of them.
std::vector<RimEdge> edges_of(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  std::vector<RimEdge> edges;
  for (Index point = 0; point < site.vertices.size(); ++point) {
    const Index from = view.representative_of(site.vertices[point]);
    const Index to = view.representative_of(site.vertices[site.polygon.next(point)]);
    edges.push_back({from, to, Eigen::AlignedBox3d(site.mesh->positions[from])});
    edges.back().box.extend(site.mesh->positions[to]);
  }
  std::ranges::sort(edges, {}, [](const RimEdge& edge) { return edge.box.min().x(); });
  return edges;
}

}  // namespace

/// The surface is asked once for all rims: each question may look at all of a large mesh.
bool rims_cross_surface(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  const std::vector<Vec3>& at = site.mesh->positions;
  const std::vector<RimEdge> edges = edges_of(site);
  Eigen::AlignedBox3d around;
  double longest = 0;
  for (const RimEdge& edge : edges) {
    around.extend(edge.box);
    longest = std::max(longest, edge.box.sizes().x());
  }
  const auto crosses = [&](Index triangle) {
    const auto& t = view.triangles[triangle];
    Eigen::AlignedBox3d box;
    for (const Index v : t) box.extend(at[v]);
    const auto first = std::ranges::lower_bound(edges, box.min().x() - longest, {},
                                                [](const RimEdge& edge) { return edge.box.min().x(); });
    for (auto edge = first; edge != edges.end() && edge->box.min().x() <= box.max().x(); ++edge) {
      if (!edge->box.intersects(box)) continue;
      if (std::ranges::any_of(t, [&](Index v) { return v == edge->from || v == edge->to; })) continue;
      if (goes_through(at[edge->from], at[edge->to], at[t[0]], at[t[1]], at[t[2]])) return true;
    }
    return false;
  };
  return std::ranges::any_of(triangles_near(site, around), crosses);
}

}  // namespace croquis::hole_filling
