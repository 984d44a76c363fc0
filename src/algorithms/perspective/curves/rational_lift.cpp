// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/curves/rational_lift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr int most_halvings = 6;

/// Depths beyond this many times the smallest one of a curve count as at the horizon.
constexpr double farthest_ratio = 1e6;

using CubicHalves = std::pair<PictureCubic, PictureCubic>;

CubicHalves halves(const PictureCubic& cubic) {
  const Vec2 a = (cubic[0] + cubic[1]) / 2;
  const Vec2 b = (cubic[1] + cubic[2]) / 2;
  const Vec2 c = (cubic[2] + cubic[3]) / 2;
  const Vec2 ab = (a + b) / 2;
  const Vec2 bc = (b + c) / 2;
  const Vec2 middle = (ab + bc) / 2;
  return {{cubic[0], a, ab, middle}, {middle, bc, c, cubic[3]}};
}

/// Weights are n · d; all points lie before the eye where they have the sign of the eye's height over the plane.
bool lift_piece(const PictureCubic& drawn, const LiftPlane& plane, const Camera& camera, RationalCubic& piece) {
  const double height = plane.offset - plane.normal.dot(camera.eye);
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 ray = camera.ray(drawn[i]);
    const double weight = plane.normal.dot(ray);
    const double depth = height / weight;
    if (!(depth > 0) || !std::isfinite(depth)) return false;
    piece.points[i] = camera.eye + depth * ray;
    if (plane.axis >= 0) piece.points[i][plane.axis] = plane.offset;
    piece.weights[i] = std::abs(weight);
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  if (most > farthest_ratio * least) return false;
  const double first = std::cbrt(piece.weights[0]);
  const double last = std::cbrt(piece.weights[3]);
  piece.weights = {1, piece.weights[1] / (first * first * last), piece.weights[2] / (first * last * last), 1};
  return true;
}

bool lift_halving(const PictureCubic& drawn, const LiftPlane& plane, const Camera& camera, int halvings,
                  std::vector<RationalCubic>& pieces) {
  RationalCubic piece;
  if (lift_piece(drawn, plane, camera, piece)) {
    if (!pieces.empty()) piece.points[0] = pieces.back().points[3];
    pieces.push_back(piece);
    return true;
  }
  if (halvings == 0) return false;
  const auto [first, second] = halves(drawn);
  return lift_halving(first, plane, camera, halvings - 1, pieces) &&
         lift_halving(second, plane, camera, halvings - 1, pieces);
}

}  // namespace

LiftPlane axis_plane(int axis, double offset) { return {Vec3::Unit(axis), offset, axis}; }

LiftPlane plane_through(const Vec3& a, const Vec3& b, const Vec3& direction) {
  const Vec3 chord = unit_or_zero(b - a);
  Vec3 normal = direction - direction.dot(chord) * chord;
  if (normal.norm() < 1e-9 * direction.norm()) normal = chord.unitOrthogonal();
  normal.normalize();
  return {normal, normal.dot(a), -1};
}

std::optional<std::vector<RationalCubic>> lifted_cubic(const PictureCubic& drawn, const LiftPlane& plane,
                                                       const Camera& camera) {
  std::vector<RationalCubic> pieces;
  if (!lift_halving(drawn, plane, camera, most_halvings, pieces)) return std::nullopt;
  return pieces;
}

std::vector<PictureCubic> moved_path(const PerspectiveStroke& stroke, const Vec2& start, const Vec2& end) {
  std::vector<PictureCubic> path = stroke.pieces;
  std::vector<double> along{0};
  for (const PictureCubic& piece : path) along.push_back(along.back() + (piece[3] - piece[0]).norm());
  const double length = along.back() > 0 ? along.back() : 1;
  const Vec2 start_shift = start - stroke.start();
  const Vec2 end_shift = end - stroke.end();
  std::vector<Vec2> shifts;  // of the joints
  for (const double place : along) shifts.push_back(start_shift + place / length * (end_shift - start_shift));
  shifts.back() = end_shift;  // of closed paths, too
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i][0] += shifts[i];
    path[i][1] += shifts[i];
    path[i][2] += shifts[i + 1];
    path[i][3] += shifts[i + 1];
    if (i > 0) path[i][0] = path[i - 1][3];
  }
  path.front()[0] = start;
  path.back()[3] = end;
  return path;
}

LiftPlane plane_of_stroke(StrokeGroup group, const Vec3& a, const Vec3& b, const Camera& camera) {
  const int axis = axis_of(group);
  if (!is_parallel(group)) {
    if (a[axis] == b[axis]) return axis_plane(axis, a[axis]);
    return plane_through(a, b, Vec3::Unit(axis));  // its group is ignored
  }
  return plane_through(a, b, (a + b) / 2 - camera.eye);
}

bool is_straight(const PictureCubic& cubic) {
  constexpr double rounding = 1e-6;  // relative to the chord: numbers of files have few digits
  const Vec2 chord = cubic[3] - cubic[0];
  const double limit = rounding * chord.squaredNorm();
  return limit > 0 && std::abs(cross(chord, cubic[1] - cubic[0])) <= limit &&
         std::abs(cross(chord, cubic[2] - cubic[0])) <= limit;
}

std::optional<std::vector<std::vector<RationalCubic>>> lifted_stroke(const PerspectiveStroke& stroke, StrokeGroup group,
                                                                     const Vec3& a, const Vec3& b,
                                                                     const Camera& camera) {
  if (stroke.straight) return {{{straight_cubic(a, b)}}};
  const LiftPlane plane = plane_of_stroke(group, a, b, camera);
  std::vector<std::vector<RationalCubic>> pieces;
  for (const PictureCubic& drawn : moved_path(stroke, camera.project(a), camera.project(b))) {
    std::optional<std::vector<RationalCubic>> lifted = lifted_cubic(drawn, plane, camera);
    if (!lifted) return std::nullopt;
    if (!pieces.empty()) lifted->front().points[0] = pieces.back().back().points[3];
    pieces.push_back(std::move(*lifted));
  }
  pieces.front().front().points[0] = a;
  pieces.back().back().points[3] = b;
  return pieces;
}

double arc_length(const RationalCubic& curve) {
  constexpr int parts = 16;
  constexpr std::array<double, 3> places{-0.7745966692414834, 0, 0.7745966692414834};
  constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  double sum = 0;
  for (int part = 0; part < parts; ++part) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum += weights[i] / parts * curve.derivative((part + 0.5 + places[i] / 2) / parts).norm();
    }
  }
  return sum;
}

}  // namespace croquis
