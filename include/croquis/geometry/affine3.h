// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// An affine map of space: p → linear · p + offset.
struct Affine3 {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 offset = Vec3::Zero();  ///< model units

  Vec3 operator()(const Vec3& point) const { return linear * point + offset; }

  /// Exactly, every number of it.
  bool is_identity() const { return *this == Affine3(); }

  /// Whether all numbers are finite and space stays a space: the axes, each taken as a unit vector, span more than
  /// 1e-12 of the volume of the unit cube. So neither units nor unequal scales count.
  bool is_invertible() const;

  /// Whether left and right change places.
  bool mirrors() const;

  friend bool operator==(const Affine3& a, const Affine3& b) { return a.linear == b.linear && a.offset == b.offset; }
};

/// Two maps one after the other: `second` of what `first` gives.
Affine3 composed(const Affine3& second, const Affine3& first);

/// The map that takes a plane's own coordinates (x along u, y along v, z along its normal) to space. Rigid.
Affine3 frame_of(const DrawingPlane& plane);

/// The mapped mesh. Channels "normal" of width 3 go by the inverse transpose and keep their lengths; a map that mirrors
/// turns every face round about its first corner, and the values of corners and edges go with them. Tags stay. Linear,
/// but for edge channels of a mirrored mesh (a topology).
/// @param map invertible
PolyMesh transformed(const PolyMesh& mesh, const Affine3& map);

/// The drawing on the mapped plane. Where the map stretches or shears the plane, the samples' positions take that up,
/// so that the axes stay orthonormal; a rigid map leaves the strokes as they were drawn. The drawing is seen from the
/// side to which u × v points, after a map that mirrors too.
/// @param map invertible
Drawing transformed(const Drawing& drawing, const Affine3& map);

}  // namespace croquis
