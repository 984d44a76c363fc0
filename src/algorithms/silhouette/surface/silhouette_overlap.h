// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// A closed outline with the surface on its left (+1) or right (-1).
struct SidedOutline {
  std::vector<Vec2> points;  ///< cyclic
  int side = 1;
};

/// Areas measured along scan lines.
struct Overlap {
  double both = 0;
  double either = 0;

  /// Intersection over union, 1 for two empty regions.
  double ratio() const { return either > 0 ? both / either : 1; }
};

/// Areas of the intersection and the union of the meshes' projection along z and the region that outlines enclose (the
/// sum of their windings, each with its side, is positive).
///
/// Exact along about 1500 lines y = constant over the outlines' diagonal, at an irrational offset. Between lines the
/// outlines count as straight: the ratio's error is below perimeter * spacing^2 / (area * radius of curvature), in
/// practice under 1e-4. O(faces + rims * lines per rim edge).
Overlap silhouette_overlap(std::span<const PolyMesh* const> meshes, const std::vector<SidedOutline>& outlines);

}  // namespace croquis::silhouette
