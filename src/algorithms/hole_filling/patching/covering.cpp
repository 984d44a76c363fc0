// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/covering.h"

#include <algorithm>
#include <cmath>

#include "algorithms/hole_filling/patching/near_scene.h"
#include "croquis/hole_filling/hole_groups.h"

namespace croquis::hole_filling {
namespace {

constexpr double covering_reach = 2;  // × cell
constexpr double uncovered_beyond =
    0.45;                          // × cell: a strip of good triangles fits between the rim and what is uncovered
constexpr double opposite = -0.5;  // cosine between the two skins of a wall

std::vector<Index> triangles_in(const HoleSite& site, const implicit::Box& box) {
  const SurfaceView& view = site.analysis->view;
  std::vector<Index> near = triangles_near(site, {box.low, box.high});
  std::erase_if(near, [&](Index t) { return (view.flags[t] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0; });
  return near;
}

std::array<Vec3, 3> corners_of(const HoleSite& site, Index triangle) {
  const auto& [a, b, c] = site.analysis->view.triangles[triangle];
  return {site.mesh->positions[a], site.mesh->positions[b], site.mesh->positions[c]};
}

std::vector<std::array<Vec3, 3>> corners_of_all(const HoleSite& site, const std::vector<Index>& triangles) {
  std::vector<std::array<Vec3, 3>> corners;
  corners.reserve(triangles.size());
  for (const Index t : triangles) corners.push_back(corners_of(site, t));
  return corners;
}

/// The direction, unit, in which a triangle goes on across its edge.
Vec3 across_edge(const std::array<Vec3, 3>& t, std::size_t edge) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  return (t[(edge + 1) % 3] - t[edge]).cross(normal).normalized();
}

/// Per vertex on any rim the sum over its rim edges.
std::vector<std::pair<Index, Vec3>> onwards_at_rims(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  std::vector<std::pair<Index, Vec3>> sums;
  for (const Index corner : view.rim_corners) {
    const Vec3 direction = across_edge(corners_of(site, corner / 3), corner % 3);
    sums.emplace_back(view.origin(corner), direction);
    sums.emplace_back(view.target(corner), direction);
  }
  std::stable_sort(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (kept > 0 && sums[kept - 1].first == sums[i].first)
      sums[kept - 1].second += sums[i].second;
    else
      sums[kept++] = sums[i];
  }
  sums.resize(kept);
  return sums;
}

}  // namespace

Covering::Covering(const HoleSite& site, const implicit::Box& box, const Progress& progress)
    : site_(site),
      triangles_(triangles_in(site, box)),
      at_rim_(onwards_at_rims(site)),
      tree_(corners_of_all(site, triangles_), progress) {
  for (const Index t : triangles_) {
    const auto [a, b, c] = corners_of(site, t);
    normals_.push_back((b - a).cross(c - a).normalized());
  }
}

/// The direction in which the surface goes on from a foot on a rim, or zero where there is surface on all sides.
Vec3 Covering::onwards(const TriangleFoot& foot) const {
  const SurfaceView& view = site_.analysis->view;
  const Index first_corner = 3 * triangles_[foot.triangle];
  if (foot.edge >= 0) {
    const bool is_rim = view.opposite[first_corner + static_cast<Index>(foot.edge)] == no_index;
    if (!is_rim) return Vec3::Zero();
    return across_edge(corners_of(site_, triangles_[foot.triangle]), static_cast<std::size_t>(foot.edge));
  }
  if (foot.corner < 0) return Vec3::Zero();
  const Index vertex = view.origin(first_corner + static_cast<Index>(foot.corner));
  const auto found = std::ranges::lower_bound(at_rim_, vertex, {}, &std::pair<Index, Vec3>::first);
  if (found == at_rim_.end() || found->first != vertex) return Vec3::Zero();
  return found->second.normalized();
}

void Covering::mark(const implicit::Field& field, double cell, std::span<const Vec3> places,
                    std::span<std::uint8_t> covered) const {
  std::vector<std::size_t> near;  // most places have nothing nearby, and need no gradient
  std::vector<Vec3> near_places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    covered[i] = 0;
    if (tree_.nearest(places[i], covering_reach * cell).triangle == no_index) continue;
    near.push_back(i);
    near_places.push_back(places[i]);
  }
  std::vector<double> values(near.size());
  std::vector<Vec3> gradients(near.size());
  field(near_places, values, gradients);
  const double least_agreement = std::cos(greatest_group_angle);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const Vec3 normal = gradients[k].normalized();
    const TriangleFoot foot = tree_.nearest(near_places[k], covering_reach * cell,
                                            [&](Index t) { return normals_[t].dot(normal) >= least_agreement; });
    if (foot.triangle == no_index) continue;
    const Vec3 direction = onwards(foot);
    const bool is_under = direction.isZero() || (near_places[k] - foot.point).dot(direction) < uncovered_beyond * cell;
    covered[near[k]] = is_under ? 1 : 0;
  }
}

double Covering::wall(double farthest) const {
  const SurfaceView& view = site_.analysis->view;
  for (const Index id : site_.holes) {
    for (const Index corner : site_.analysis->holes[id].corners) {
      const auto [a, b, c] = corners_of(site_, corner / 3);
      const Vec3 normal = (b - a).cross(c - a).normalized();
      const TriangleFoot foot = tree_.nearest(site_.mesh->positions[view.origin(corner)], farthest,
                                              [&](Index t) { return normals_[t].dot(normal) < opposite; });
      if (foot.triangle != no_index) farthest = foot.distance;
    }
  }
  return farthest;
}

}  // namespace croquis::hole_filling
