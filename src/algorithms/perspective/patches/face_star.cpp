// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/face_star.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Steepest rise of a spoke from a side towards the middle of the face, radians.
constexpr double steepest_spoke = 1.9;

Vec3 tip(const StarShape& shape, const std::vector<FaceSide>& sides, std::size_t i) {
  return sides[i].middle + shape.start_legs[i];
}

/// The axis that the sides' middles lie around, or `normal` if they lie in a line.
Vec3 axis_of(const std::vector<FaceSide>& sides, const Vec3& base, const Vec3& normal) {
  Vec3 axis = Vec3::Zero();
  double scale = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec3 a = sides[i].middle - base, b = sides[(i + 1) % sides.size()].middle - base;
    axis += a.cross(b);
    scale += a.norm() * b.norm();
  }
  return axis.norm() > 1e-6 * scale ? axis.normalized() : normal;
}

/// From the middle of side i to the middle of the face, seen by the patch of that side's start.
PatchSide spoke(const std::vector<FaceSide>& sides, const StarShape& shape, std::size_t i) {
  PatchSide result;
  result.points = {sides[i].middle, tip(shape, sides, i), shape.middle + shape.end_legs[i], shape.middle};
  result.common = true;
  result.across = {-sides[i].tangent, shape.normal.cross(-shape.end_legs[i]).normalized()};
  return result;
}

PatchSide turned_side(const PatchSide& side) {
  return {{side.points[3], side.points[2], side.points[1], side.points[0]},
          side.common,
          {-side.across[1], -side.across[0]}};
}

}  // namespace

StarShape round_star(const std::vector<FaceSide>& sides, const Vec3& normal) {
  const auto count = static_cast<double>(sides.size());
  Vec3 base = Vec3::Zero();
  for (const FaceSide& side : sides) base += side.middle / count;
  const Vec3 axis = axis_of(sides, base, normal);
  StarShape shape;
  shape.normal = normal;
  double height = 0;
  for (const FaceSide& side : sides) {
    const Vec3 out = side.middle - base - axis.dot(side.middle - base) * axis;
    const double angle = std::clamp(std::atan2(axis.dot(side.inwards), -out.normalized().dot(side.inwards)),
                                    -steepest_spoke, steepest_spoke);
    const double radius = std::abs(angle) > 1e-6 ? out.norm() / std::sin(std::abs(angle)) : 0;
    const double handle = radius > 0 ? 4.0 / 3.0 * std::tan(std::abs(angle) / 4) * radius : out.norm() / 3;
    shape.start_legs.push_back(handle * side.inwards);
    shape.end_legs.push_back(shape.start_legs.back());
    height += (axis.dot(side.middle - base) + out.norm() * std::tan(angle / 2)) / count;
  }
  return with_middle(shape, sides, base + height * axis);
}

StarShape with_middle(const StarShape& shape, const std::vector<FaceSide>& sides, const Vec3& middle) {
  StarShape moved = shape;
  moved.middle = middle;
  moved.normal = Vec3::Zero();
  double scale = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec3 a = tip(shape, sides, i) - middle, b = tip(shape, sides, (i + 1) % sides.size()) - middle;
    moved.normal += a.cross(b);
    scale += a.norm() * b.norm();
  }
  // Two sides: the spokes are one line.
  moved.normal = moved.normal.norm() > 1e-6 * scale ? moved.normal.normalized() : shape.normal;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Vec3 back = tip(shape, sides, i) - middle;
    back -= moved.normal.dot(back) * moved.normal;
    moved.end_legs[i] = shape.end_legs[i].norm() * back.normalized();
  }
  return moved;
}

GregoryPatch star_patch(const std::vector<FaceSide>& sides, const StarShape& shape, std::size_t i,
                        const PatchOptions& options) {
  const std::size_t before = (i + sides.size() - 1) % sides.size();
  return span_patch(
      {sides[i].first, spoke(sides, shape, i), turned_side(spoke(sides, shape, before)), sides[before].second},
      options);
}

std::vector<GregoryPatch> star_patches(const std::vector<FaceSide>& sides, const StarShape& shape,
                                       const PatchOptions& options) {
  std::vector<GregoryPatch> patches;
  for (std::size_t i = 0; i < sides.size(); ++i) patches.push_back(star_patch(sides, shape, i, options));
  return patches;
}

}  // namespace croquis
