// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// Cuts edges of a mesh in their middles: a triangle with k of them becomes k + 1, in its place in the order of faces.
/// Nothing opens, and what faces carry is kept.
/// @param mesh triangles with channels of faces alone
/// @param cuts whether an edge is cut, by one of its faces and its ends; asked for each of its faces until one does
/// @return whether any was cut
bool cut_edges(PolyMesh& mesh, const std::function<bool(Index face, const Vec3& a, const Vec3& b)>& cuts);

}  // namespace croquis::silhouette
