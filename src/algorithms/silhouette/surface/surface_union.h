// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
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

/// What several closed surfaces enclose together. The largest part first, so that the others are joined to it one by
/// one. Exact predicates; new points are rounded to doubles. Slivers along the seams are then removed, which moves the
/// seams by no more than the length given: rounded to a file's digits they would cut one another.
/// @param parts   closed, outward, each free of self-intersections
/// @param sliver  seam edges shorter than this may go, sketch units
/// @return none when the parts meet in a way that has no sound union; what is returned must be checked all the same
/// O(n log n) in practice. @throws Cancelled
std::optional<SurfaceUnion> unite_surfaces(std::span<const UnionPart> parts, double sliver, Progress& progress);

}  // namespace croquis::silhouette
