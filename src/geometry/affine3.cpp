// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/affine3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "croquis/base/limits.h"
#include "croquis/geometry/edge_channels.h"

namespace croquis {
namespace {

/// Less of the unit cube's volume than this is left by maps that flatten space, up to the rounding of their numbers.
constexpr double least_volume = 1e-12;

/// Up to this, axes of length 1 at a right angle are taken as such: what rounding makes of them.
constexpr double axis_tolerance = 1e-9;

/// Normals keep their lengths, since whole numbers have a unit of their own; NaN stays NaN.
template <typename T>
void turn_normals(std::vector<T>& values, const Eigen::Matrix3d& inverse_transpose) {
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    const Vec3 old(static_cast<double>(values[i]), static_cast<double>(values[i + 1]),
                   static_cast<double>(values[i + 2]));
    const Vec3 turned = old.norm() * unit_or_zero(inverse_transpose * old);
    if (!turned.allFinite()) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[i + axis] = stored_value<T>(turned[static_cast<Eigen::Index>(axis)]);
  }
}

/// Per corner of the turned mesh, the corner that stood for the same vertex of its face.
std::vector<Index> turned_corners(const PolyMesh& mesh) {
  std::vector<Index> sources(mesh.corners.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Index begin = mesh.face_offsets[face];
    const Index end = mesh.face_offsets[face + 1];
    for (Index corner = begin; corner < end; ++corner) sources[corner] = corner == begin ? begin : begin + end - corner;
  }
  return sources;
}

void turn_faces(PolyMesh& mesh) {
  const PolyMesh old = mesh;
  const std::vector<Index> sources = turned_corners(old);
  for (std::size_t corner = 0; corner < sources.size(); ++corner) mesh.corners[corner] = old.corners[sources[corner]];
  for (AttributeChannel& channel : mesh.channels) {
    // One of another length belongs to nothing that turns.
    const bool fits = channel.size() == sources.size() * static_cast<std::size_t>(std::max(channel.width, 0));
    if (channel.domain == Domain::Corner && fits) channel = gathered(channel, sources);
  }
  renumber_edge_channels(old, {}, mesh);
}

}  // namespace

bool DrawingPlane::is_orthonormal() const {
  return are_usable_numbers(origin) && std::abs(u.norm() - 1) <= axis_tolerance &&
         std::abs(v.norm() - 1) <= axis_tolerance && std::abs(u.dot(v)) <= axis_tolerance;
}

bool Affine3::is_invertible() const {
  if (!are_usable_numbers(linear.reshaped()) || !are_usable_numbers(offset)) return false;
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = linear.col(i).stableNormalized();
  return std::abs(axes.determinant()) > least_volume;
}

bool Affine3::mirrors() const {
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = linear.col(i).stableNormalized();
  return axes.determinant() < 0;
}

Affine3 composed(const Affine3& second, const Affine3& first) {
  return {second.linear * first.linear, second(first.offset)};
}

Affine3 frame_of(const DrawingPlane& plane) {
  Affine3 frame;
  frame.linear.col(0) = plane.u;
  frame.linear.col(1) = plane.v;
  frame.linear.col(2) = plane.u.cross(plane.v);
  frame.offset = plane.origin;
  return frame;
}

PolyMesh transformed(const PolyMesh& mesh, const Affine3& map) {
  PolyMesh result = mesh;
  for (Vec3& position : result.positions) position = map(position);
  const Eigen::Matrix3d inverse_transpose = map.linear.inverse().transpose();
  for (AttributeChannel& channel : result.channels) {
    if (channel.name != "normal" || channel.width != 3) continue;
    std::visit([&](auto& values) { turn_normals(values, inverse_transpose); }, channel.data);
  }
  if (map.mirrors()) turn_faces(result);
  return result;
}

Drawing transformed(const Drawing& drawing, const Affine3& map) {
  Drawing result = drawing;
  const Vec3 u = map.linear * drawing.plane.u;
  const Vec3 v = map.linear * drawing.plane.v;
  result.plane.origin = map(drawing.plane.origin);
  result.plane.u = u.normalized();
  result.plane.v = (v - v.dot(result.plane.u) * result.plane.u).normalized();
  Eigen::Matrix2d within;
  within << u.norm(), v.dot(result.plane.u), 0, v.dot(result.plane.v);
  if (within.isIdentity(axis_tolerance)) return result;
  for (Stroke& stroke : result.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position = within * sample.position;
  }
  return result;
}

}  // namespace croquis
