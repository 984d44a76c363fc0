// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// Wavefront OBJ: vertices in order with their colours, faces with uv and normals, groups, objects, materials and
/// smoothing groups, then polylines, then creases and pins.
MeshWriteResult write_obj(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
