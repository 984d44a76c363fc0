// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "croquis/geometry/poly_mesh.h"
#include "io/read_context.h"

namespace croquis {

/// Reads the meshes of all nodes of a GLB file, where their nodes put them. Equal positions are joined, since files
/// repeat a vertex wherever its normal or its place in a texture changes.
/// @throws Error Malformed as read_mesh; Limit: E_TOO_LARGE when nodes repeat meshes too often
PolyMesh read_glb(std::string_view bytes, ReadContext& context);

}  // namespace croquis
