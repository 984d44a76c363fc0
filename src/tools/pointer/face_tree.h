// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

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

/// A tree of boxes around the faces of a mesh: faces in the order of a Morton curve through their middles, four to a
/// leaf, and a complete binary tree above, without pointers.
///
/// Sorting by the curve takes O(n) where better splits take O(n log n) with a greater constant; so a million faces are
/// ready without a visible delay, and after a drag the boxes alone are computed again. Source: Lauterbach et al.
/// 2009, "Fast BVH construction on GPUs", section 3.
class FaceTree {
 public:
  /// @param mesh positions finite
  explicit FaceTree(const PolyMesh& mesh);

  /// The same faces with other positions. O(#C).
  void refit(const PolyMesh& mesh);

  struct Hit {
    Index face = no_index;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The first face between two distances along a ray; the lower number of two at one place.
  Hit first(const PolyMesh& mesh, const Ray& ray, double from, double to) const;

  /// Whether any face but these (sorted) lies between.
  bool any(const PolyMesh& mesh, const Ray& ray, double from, double to, const std::vector<Index>& except) const;

  /// Half spaces: x, y, z, 1 times the vector is >= 0 inside.
  using Planes = std::vector<Eigen::Vector4d>;

  /// Faces whose box isn't outside of one of them, in the tree's order.
  std::vector<Index> near(const Planes& planes) const;

 private:
  /// Rounded outwards, so that single precision loses nothing.
  struct Box {
    std::array<float, 3> low, high;
  };
  static constexpr Index leaf_faces = 4;

  static Box empty_box();
  static void add(Box& box, const Box& other);
  static Box box_of(const PolyMesh& mesh, Index face);
  Index leaf_count() const { return static_cast<Index>(boxes_.size() / 2); }

  template <typename Visit>
  void walk(const Ray& ray, double from, double& to, Visit visit) const;

  std::vector<Index> order_;  ///< #F
  std::vector<Box> boxes_;    ///< node i has children 2 i and 2 i + 1; 1 is the root; leaves are the second half
};

}  // namespace croquis
