// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// A closed surface of triangles, and its objects.
struct UnionPart {
  const PolyMesh* mesh = nullptr;
  Index object = 0;
};

struct SurfaceUnion {
  PolyMesh mesh;
  std::vector<Index> face_objects;  ///< per face the object of the part that it is a piece of
};

/// How a part and a surface that grows met.
enum class Meeting {
  Joined,
  Apart,   ///< they have no point in common, or one lies within the other
  Unsound  ///< they have no sound union
};

/// What several closed surfaces enclose together, joined one by one. Exact predicates; new points are rounded to
/// doubles. Slivers along the seams are removed after each part, which moves the seams by no more than the length
/// given: a later part that crosses a seam of slivers would find that they cut one another, and so would a file that
/// rounds to its digits.
class GrowingUnion {
 public:
  /// @param first   closed, outward, free of self-intersections, as all parts must be
  /// @param sliver  seam edges shorter than this may go, sketch units
  GrowingUnion(const UnionPart& first, double sliver);
  ~GrowingUnion();

  /// Unless the part is joined, the surface stays as it was. O(n log n) in practice.
  Meeting add(const UnionPart& part);

  /// The surface so far; it must be checked all the same. None where its slivers can't be removed.
  std::optional<SurfaceUnion> take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of the surface seen from the viewer, every layer counted; twice the area.
double projected_area(const PolyMesh& mesh);

}  // namespace croquis::silhouette
