// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/hole_filling/continuation/other_sheets.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// Moves a patch's new vertices so that the vertex nearest to each place comes to lie there and the others follow
/// softly: the displacement bends least (umbrella Laplacian, squared), and neither moves nor tilts at the rims.
/// Near-linear in the patch. @return false when the patch has too few new vertices
bool displace_through(const PolyMesh& mesh, HolePatch& patch, std::span<const Vec3> places);

/// Places of a patch with their normals, no two nearer than `spacing`, which grows until they are `most` at most.
std::vector<PassingPoint> spread_points(const PolyMesh& mesh, const HolePatch& patch, double spacing, std::size_t most);

}  // namespace croquis::hole_filling
