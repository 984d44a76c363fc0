// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/rim_hinge.h"

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

constexpr int tangent_smoothings = 3;        // of the tangents: rims of removed triangles run in a zigzag
constexpr std::size_t hinge_neighbours = 6;  // rim vertices that a point is turned about

/// Both neighbours' difference, then each the mean with its neighbours'.
std::vector<Vec3> rim_tangents(const RimPolygon& polygon) {
  std::vector<Index> previous(polygon.points.size());
  for (Index i = 0; i < polygon.points.size(); ++i) previous[polygon.next(i)] = i;
  std::vector<Vec3> tangents;
  for (Index i = 0; i < polygon.points.size(); ++i)
    tangents.push_back((polygon.points[polygon.next(i)] - polygon.points[previous[i]]).normalized());
  for (int round = 0; round < tangent_smoothings; ++round) {
    const std::vector<Vec3> before = tangents;
    for (Index i = 0; i < tangents.size(); ++i)
      tangents[i] = (before[previous[i]] + 2 * before[i] + before[polygon.next(i)]).normalized();
  }
  return tangents;
}

}  // namespace

RimHinge::RimHinge(const HoleSite& site, double bulge)
    : points_(site.polygon.points),
      tangents_(rim_tangents(site.polygon)),
      tree_(points_),
      angle_(bulge * angle_of_bulge) {}

std::vector<RimHinge::Turn> RimHinge::turns_at(const Vec3& point) const {
  std::vector<Turn> turns;
  double sum = 0;
  for (const Index i : tree_.nearest(point, hinge_neighbours)) {
    const double squared = (points_[i] - point).squaredNorm();
    if (squared == 0) return {{tangents_[i], points_[i], 1}};
    turns.push_back({tangents_[i], points_[i], 1 / squared});
    sum += turns.back().weight;
  }
  for (Turn& turn : turns) turn.weight /= sum;
  return turns;
}

Vec3 RimHinge::place(const Vec3& point) const {
  Vec3 moved = Vec3::Zero();
  for (const Turn& turn : turns_at(point))
    moved += turn.weight * (turn.pivot + Eigen::AngleAxisd(angle_, turn.about) * (point - turn.pivot));
  return moved;
}

Vec3 RimHinge::normal(const Vec3& point, const Vec3& normal) const {
  Vec3 turned = Vec3::Zero();
  for (const Turn& turn : turns_at(point)) turned += turn.weight * (Eigen::AngleAxisd(angle_, turn.about) * normal);
  const double length = turned.norm();
  return length > 0 ? Vec3(turned / length) : normal;
}

}  // namespace croquis::hole_filling
