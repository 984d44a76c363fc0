// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/surface/drawing_plane.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr double edge_on = 3 * std::numbers::pi / 180;  // a plane seen flatter than that can't be pointed at
constexpr double too_flat = 15 * std::numbers::pi / 180;

Vec3 line_of_sight(const ViewFrame& frame, const Vec3& place) { return frame.to_eye(place); }

}  // namespace

std::optional<Vec3> place_on(const SpacePlane& plane, const ViewFrame& frame, const Vec2& pixel) {
  const Ray sight = frame.sight(pixel);
  const Vec3 normal = plane.normal.normalized();
  const double slant = sight.direction.dot(normal);
  if (std::abs(slant) < std::sin(edge_on)) return std::nullopt;
  const double along = (plane.point - sight.origin).dot(normal) / slant;
  const Vec3 place = sight.at(along);
  if (frame.perspective() && (along <= 0 || !frame.project(place))) return std::nullopt;
  return place.allFinite() ? std::optional(place) : std::nullopt;
}

SpacePlane view_plane(const ViewFrame& frame, const Vec3& place) {
  return {place, frame.right().cross(frame.up()).normalized()};
}

SpacePlane plane_through(const ViewFrame& frame, const Vec3& a, const Vec3& b) {
  const Vec3 chord = b - a;
  const Vec3 to_eye = line_of_sight(frame, (a + b) / 2);
  const Vec3 across = to_eye - chord * (chord.dot(to_eye) / std::max(chord.squaredNorm(), 1e-300));
  if (!(chord.norm() > 0) || across.norm() < std::sin(edge_on)) return view_plane(frame, a);
  return {a, across.normalized()};
}

SpacePlane ground_or_view(const ViewFrame& frame, const SpacePlane& ground) {
  const Vec2 middle = frame.size / 2;
  const Ray sight = frame.sight(middle);
  const Vec3 normal = ground.normal.normalized();
  if (std::abs(sight.direction.dot(normal)) >= std::sin(too_flat)) return ground;
  return view_plane(frame, ground.point);
}

}  // namespace croquis
