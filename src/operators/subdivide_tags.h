// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "croquis/document/operation.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/rules.h"

namespace croquis {

/// Both meshes' tags in one: where both tag an edge, or have a set of the same name, that of `added` counts.
/// O(#tags log #tags)
MeshTags united_tags(const MeshTags& own, const MeshTags& added);

/// The input "tags" of operations on the input "cage".
PortDescription tags_input();
/// The cage with the tags of that input, where it is there; what was wrong with them goes to the warnings.
std::shared_ptr<const PolyMesh> tagged_cage(const Values& inputs, Findings& warnings);

/// Tags every edge whose faces meet at more than an angle as infinitely sharp, except those with a tag of their own
/// and the boundary. Faces of the wrong orientation count as they would be repaired; normals of polygons are
/// Newell's. Linear time, but for sorting the tags.
/// @param angle radians between the faces' normals, > 0
/// @throws Error like subdivision::make_cage
MeshTags with_sharp_angles(const PolyMesh& mesh, double angle, const subdivision::Rules& rules);

}  // namespace croquis
