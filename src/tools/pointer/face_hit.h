// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// Meets a face seen along one ray: its corners in a frame across the ray, so that faces with a common edge leave no
/// gap between them.
class FaceHit {
 public:
  explicit FaceHit(const Ray& ray);

  /// Distance along the ray, nothing when it misses or the face is seen from its edge. From either side; < 0 is behind
  /// the origin.
  std::optional<double> distance(const PolyMesh& mesh, Index face) const;

 private:
  struct Seen {
    double x, y, depth;
  };
  Seen seen(const Vec3& place) const;
  static std::optional<double> triangle(const Seen& a, const Seen& b, const Seen& c);
  std::optional<double> quad(const PolyMesh& mesh, std::span<const Index> corners) const;
  std::optional<double> polygon(const PolyMesh& mesh, Index face) const;

  Ray ray_;
  Vec3 x_, y_;  ///< across the ray
};

}  // namespace croquis
