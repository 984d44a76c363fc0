// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::test {

/// Distances to triangles, through a tree of boxes: n log n to build, about log n per point. Keeps copies.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const PolyMesh& mesh) : SurfaceDistance(mesh, 0) {}

  /// To the faces from `first_face` on alone: patches are appended behind the faces given.
  SurfaceDistance(const PolyMesh& mesh, std::size_t first_face);

  SurfaceDistance(const PolyMesh& mesh, std::span<const Index> faces);

  /// Infinity without faces.
  double operator()(const Vec3& point) const;

 private:
  struct Triangle {
    Vec3 a, b, c;
  };
  struct Node {
    Vec3 low, high;
    std::size_t begin = 0, end = 0;  // of its triangles
    std::size_t right = 0;           // its second child, the first one follows it; 0: a leaf
  };

  void add_fan(const PolyMesh& mesh, std::size_t face);
  void build(std::size_t begin, std::size_t end);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// About `count` places on faces, evenly by area, in the order of the faces.
std::vector<Vec3> sample_faces(const PolyMesh& mesh, std::span<const Index> faces, std::size_t count,
                               std::uint64_t seed = 1);

struct DistanceSummary {
  double mean = 0, greatest = 0;
};

DistanceSummary summary_of_distances(std::span<const Vec3> points, const SurfaceDistance& surface);

}  // namespace croquis::test
