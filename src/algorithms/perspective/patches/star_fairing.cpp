// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/star_fairing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/perspective/patches/patch_fairing.h"

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

/// A spoke's handles stay within these parts of what they were, seen along their first direction.
constexpr double shortest_handle = 0.2, longest_handle = 4;

/// What may move: the middle (3), the normal there (2), and of each spoke the handle at the side (2 or 3) and the one
/// at the middle (2). Values are parts of the longest handle at the middle.
class StarFamily : public PatchFamily {
 public:
  StarFamily(const std::vector<FaceSide>& sides, const StarShape& start) : sides_(sides), start_(start) {
    size_ = 0;
    for (const Vec3& leg : start.end_legs) size_ = std::max(size_, leg.norm());
    plane_ = {start.end_legs[0].normalized(), start.normal.cross(start.end_legs[0].normalized())};
    int next = 5;
    for (const FaceSide& side : sides) {
      first_.push_back(next);
      bases_.push_back({side.tangent, side.inwards});
      // Where faces go on smoothly into each other the handle stays in their tangent plane.
      if (!side.first.common) bases_.back().push_back(side.tangent.cross(side.inwards).normalized());
      next += static_cast<int>(bases_.back().size()) + 2;
    }
    first_.push_back(next);
  }

  std::size_t patches() const override { return sides_.size(); }
  int variables() const override { return first_.back(); }

  std::vector<int> variables_of(std::size_t patch) const override {
    const std::size_t before = (patch + sides_.size() - 1) % sides_.size();
    std::vector<int> result = {0, 1, 2, 3, 4};
    for (const std::size_t spoke : {before, patch}) {
      for (int v = first_[spoke]; v < first_[spoke + 1]; ++v) result.push_back(v);
    }
    return result;
  }

  std::vector<PatchJoint> joints() const override {
    std::vector<PatchJoint> joints;
    for (std::size_t i = 0; i < sides_.size(); ++i) joints.push_back({i, 1, (i + 1) % sides_.size(), 2});
    return joints;
  }

  GregoryPatch patch(std::size_t index, const Eigen::VectorXd& values) const override {
    return star_patch(sides_, shape(values), index);
  }

  StarShape shape(const Eigen::VectorXd& values) const {
    StarShape shape = start_;
    shape.middle += size_ * values.head<3>();
    shape.normal = (start_.normal + values[3] * plane_[0] + values[4] * plane_[1]).normalized();
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      int v = first_[i];
      for (const Vec3& direction : bases_[i]) shape.start_legs[i] += size_ * values[v++] * direction;
      shape.end_legs[i] += size_ * (values[v] * plane_[0] + values[v + 1] * plane_[1]);
      shape.end_legs[i] -= shape.normal.dot(shape.end_legs[i]) * shape.normal;
    }
    return shape;
  }

  /// No handle may become too short, too long or turn round.
  bool allowed(const Eigen::VectorXd& values) const override {
    const auto near = [](const Vec3& now, const Vec3& then) {
      const double part = now.dot(then) / then.squaredNorm();
      return part > shortest_handle && part < longest_handle;
    };
    const StarShape now = shape(values);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (!near(now.start_legs[i], start_.start_legs[i]) || !near(now.end_legs[i], start_.end_legs[i])) return false;
    }
    return true;
  }

 private:
  const std::vector<FaceSide>& sides_;
  const StarShape& start_;
  double size_ = 1;
  std::array<Vec3, 2> plane_;             // at right angles to the first normal
  std::vector<std::vector<Vec3>> bases_;  // per spoke, of its handle at the side
  std::vector<int> first_;                // per spoke, its first variable; then the number of variables
};

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

GregoryPatch star_patch(const std::vector<FaceSide>& sides, const StarShape& shape, std::size_t i) {
  const std::size_t before = (i + sides.size() - 1) % sides.size();
  return span_patch(
      {sides[i].first, spoke(sides, shape, i), turned_side(spoke(sides, shape, before)), sides[before].second});
}

std::vector<GregoryPatch> star_patches(const std::vector<FaceSide>& sides, const StarShape& shape) {
  std::vector<GregoryPatch> patches;
  for (std::size_t i = 0; i < sides.size(); ++i) patches.push_back(star_patch(sides, shape, i));
  return patches;
}

StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start) {
  const StarFamily family(sides, start);
  return family.shape(least_energy(family));
}

}  // namespace croquis
