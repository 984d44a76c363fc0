// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// A closed mesh of triangles whose half on the right of a plane x = axis is the mirror image of that on the left: a
/// vertex at axis - d has its twin at axis + d, up to rounding. Vertices near the plane are moved onto it.
/// @param mesh with the face channel "object"; of other channels nothing is kept
/// @param twins per object the one that its mirror image belongs to
/// @return nothing where the result wouldn't be closed, manifold, free of intersections and of the same Euler number
std::optional<PolyMesh> with_mirrored_half(const PolyMesh& mesh, double axis, std::span<const std::int32_t> twins,
                                           Progress& progress);

}  // namespace croquis::silhouette
