// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

struct SelfIntersectionOptions {
  std::size_t max_pairs = 1000;  ///< pairs listed at most; all are counted
};

struct SelfIntersections {
  std::size_t count = 0;                    ///< pairs of faces that intersect
  std::vector<std::array<Index, 2>> pairs;  ///< the first of them in lexicographic order, each (low, high)
};

/// Finds the pairs of faces that meet anywhere but in the vertices and edges they share.
///
/// Polygons count as the triangles they are cut into (see polygon_cut); (f, f): those of one polygon overlap.
/// Shared means the same vertex index: sheets that touch without sharing, even in one point or along a seam with
/// coordinates that agree, do intersect, as do duplicate faces. Triangles without an area (on one line, exactly) are
/// left out: `degenerate_faces` lists the faces. All decisions are exact on the coordinates as given. Any soup is
/// accepted.
///
/// Close to linear for meshes whose boxes overlap few others, quadratic in the worst case. Memory is linear whatever
/// the number of pairs. The fraction reported is an estimate.
/// @throws Error (E_INDEX, E_NOT_FINITE) for a mesh whose indices or positions are unusable
/// @throws Cancelled
SelfIntersections find_self_intersections(const PolyMesh& mesh, Progress& progress,
                                          const SelfIntersectionOptions& options = {});

/// The same, but only of pairs in which at least one of `faces` takes part. Costs about as much as these faces and what
/// lies near them, beside one look at every face's box.
/// @param faces indices of faces of the mesh, ascending
SelfIntersections find_intersections_of(const PolyMesh& mesh, std::span<const Index> faces, Progress& progress,
                                        const SelfIntersectionOptions& options = {});

}  // namespace croquis
