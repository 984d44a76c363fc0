// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/star_fairing.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "algorithms/perspective/patches/patch_fairing.h"

namespace croquis {
namespace {

/// A spoke's handles stay within these parts of what they were, seen along their first direction.
constexpr double shortest_handle = 0.2, longest_handle = 4;

/// What may move: the middle (3), the normal there (2), and of each spoke the handle at the side (2 or 3) and the one
/// at the middle (2). Values are parts of the longest handle at the middle.
class StarFamily : public PatchFamily {
 public:
  StarFamily(const std::vector<FaceSide>& sides, const StarShape& start, const PatchOptions& options)
      : sides_(sides), start_(start), options_(options) {
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
    return star_patch(sides_, shape(values), index, options_);
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
  const PatchOptions& options_;
  double size_ = 1;
  std::array<Vec3, 2> plane_;             // at right angles to the first normal
  std::vector<std::vector<Vec3>> bases_;  // per spoke, of its handle at the side
  std::vector<int> first_;                // per spoke, its first variable; then the number of variables
};

}  // namespace

StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start, const PatchOptions& options) {
  const StarFamily family(sides, start, options);
  return family.shape(least_energy(family));
}

}  // namespace croquis
