// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::test {

/// Distances to the triangles of faces.
class SurfaceDistance {
 public:
  /// To the faces from `first_face` on: patches are appended behind the faces given.
  explicit SurfaceDistance(const PolyMesh& mesh, std::size_t first_face = 0);

  SurfaceDistance(const PolyMesh& mesh, std::span<const Index> faces);

  /// Infinity without faces.
  double operator()(const Vec3& point) const;

 private:
  TriangleTree tree_;
};

/// About `count` places on faces, evenly by area, in the order of the faces.
std::vector<Vec3> sample_faces(const PolyMesh& mesh, std::span<const Index> faces, std::size_t count,
                               std::uint64_t seed = 1);

struct DistanceSummary {
  double mean = 0, greatest = 0;
};

DistanceSummary summary_of_distances(std::span<const Vec3> points, const SurfaceDistance& surface);

}  // namespace croquis::test
