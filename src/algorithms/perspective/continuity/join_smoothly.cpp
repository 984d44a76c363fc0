// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/Geometry>

#include "algorithms/perspective/solid/plane_axes.h"
#include "croquis/perspective/edge_continuity.h"

namespace croquis {
namespace {

/// A line counts as lying in a curve's plane up to this (component of its unit direction).
constexpr double in_plane = 1e-9;

/// How the handle at an end of a curve is reached.
struct EndHandle {
  RationalCubic* piece = nullptr;
  std::size_t point = 0;   ///< the end
  std::size_t handle = 0;  ///< its neighbour

  Vec3 leg() const { return piece->points[handle] - piece->points[point]; }
};

class JointMaker {
 public:
  JointMaker(CurveNetwork& network, const Camera* camera, const CurveContinuityOptions& options)
      : network_(network), camera_(camera), options_(options) {}

  std::vector<SmoothJoint> run() {
    std::vector<SmoothJoint> joints = candidates();
    const auto place = [&](const CurveEnd& end) {
      const Vec3 far = handle_of({end.curve, !end.at_end}).piece->points[end.at_end ? 0 : 3];
      const Vec3 leg = handle_of(end).leg();
      return std::array{far.x(), far.y(), far.z(), leg.x(), leg.y(), leg.z()};
    };
    std::ranges::stable_sort(joints, {}, [&](const SmoothJoint& joint) {
      return std::tuple(joint.angle, std::minmax({place(joint.a), place(joint.b)}));
    });
    std::vector<SmoothJoint> made;
    std::set<CurveEnd> taken;
    for (const SmoothJoint& joint : joints) {
      if (taken.contains(joint.a) || taken.contains(joint.b)) continue;
      if (!join(joint)) continue;
      taken.insert(joint.a);
      taken.insert(joint.b);
      made.push_back(joint);
    }
    return made;
  }

 private:
  EndHandle handle_of(const CurveEnd& end) const {
    NetworkCurve& curve = network_.curves[end.curve];
    return end.at_end ? EndHandle{&curve.pieces.back(), 3, 2} : EndHandle{&curve.pieces.front(), 0, 1};
  }

  double limit_of(const CurveEnd& a, const CurveEnd& b) const {
    const auto has = [](const std::vector<CurveEnd>& ends, const CurveEnd& end) {
      return std::ranges::count(ends, end);
    };
    if (has(options_.corners, a) + has(options_.corners, b) > 0) return -1;
    return has(options_.smooth, a) + has(options_.smooth, b) > 0 ? 2 * options_.angle : options_.angle;
  }

  std::vector<SmoothJoint> candidates() const {
    std::vector<std::vector<CurveEnd>> ends(network_.vertices.size());
    for (Index c = 0; c < network_.curves.size(); ++c) {
      ends[network_.curves[c].start].push_back({c, false});
      ends[network_.curves[c].end].push_back({c, true});
    }
    std::vector<SmoothJoint> joints;
    for (const std::vector<CurveEnd>& here : ends) {
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = i + 1; j < here.size(); ++j) {
          const Vec3 a = handle_of(here[i]).leg(), b = handle_of(here[j]).leg();
          if (a.isZero(0) || b.isZero(0)) continue;
          const double angle = angle_between(a, -b);
          if (angle < limit_of(here[i], here[j])) joints.push_back({here[i], here[j], angle});
        }
      }
    }
    return joints;
  }

  /// The axis that a curve lies at right angles to, if any.
  std::optional<int> plane_of(const NetworkCurve& curve) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (common_level(curve.pieces, axis) != nullptr) return axis;
    }
    return std::nullopt;
  }

  /// The direction that end a is to have and end b the opposite of, if there is one.
  std::optional<Vec3> direction(const SmoothJoint& joint) const {
    const NetworkCurve &a = network_.curves[joint.a.curve], &b = network_.curves[joint.b.curve];
    const Vec3 leg_a = handle_of(joint.a).leg(), leg_b = handle_of(joint.b).leg();
    if (a.straight) return fits_plane(b, leg_a) ? std::optional<Vec3>(leg_a.normalized()) : std::nullopt;
    if (b.straight) return fits_plane(a, leg_b) ? std::optional<Vec3>(-leg_b.normalized()) : std::nullopt;
    const std::optional<int> k = plane_of(a), l = plane_of(b);
    if (!k || !l || *k == *l) {
      const Vec3 mean = leg_a - leg_b;  // legs are as long as handles: that weights them
      if (mean.isZero(0) || !fits_plane(a, mean) || !fits_plane(b, mean)) return std::nullopt;
      return mean.normalized();
    }
    Vec3 axis = Vec3::Unit(3 - *k - *l);
    if (axis.dot(leg_a) < 0) axis = -axis;
    const bool near = angle_between(axis, leg_a) < options_.angle && angle_between(-axis, leg_b) < options_.angle;
    return near ? std::optional<Vec3>(axis) : std::nullopt;
  }

  bool fits_plane(const NetworkCurve& curve, const Vec3& direction) const {
    const std::optional<int> axis = curve.straight ? std::nullopt : plane_of(curve);
    return !axis || std::abs(direction[*axis]) <= in_plane * direction.norm();
  }

  bool join(const SmoothJoint& joint) {
    const bool lines = network_.curves[joint.a.curve].straight && network_.curves[joint.b.curve].straight;
    if (lines) return joint.angle <= in_plane;
    const std::optional<Vec3> along = direction(joint);
    if (!along) return false;
    turn(joint.a, *along);
    turn(joint.b, -*along);
    return true;
  }

  void turn(const CurveEnd& end, const Vec3& direction) {
    NetworkCurve& curve = network_.curves[end.curve];
    if (curve.straight) return;
    const EndHandle handle = handle_of(end);
    const std::optional<int> axis = plane_of(curve);
    const Vec3 old = handle.piece->points[handle.handle];
    Vec3 moved = handle.piece->points[handle.point] + handle.leg().norm() * direction;
    if (axis) moved[*axis] = handle.piece->points[handle.point][*axis];
    handle.piece->points[handle.handle] = moved;
    // The weight of a control point that is seen at a place of the picture is one by its depth.
    if (camera_ != nullptr) handle.piece->weights[handle.handle] *= camera_->depth(old) / camera_->depth(moved);
  }

  CurveNetwork& network_;
  const Camera* camera_;
  const CurveContinuityOptions& options_;
};

}  // namespace

std::vector<SmoothJoint> join_smoothly(CurveNetwork& network, const Camera* camera,
                                       const CurveContinuityOptions& options) {
  return JointMaker(network, camera, options).run();
}

}  // namespace croquis
