// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// Binary glTF 2.0: one mesh of triangles, and polylines as lines, with the vertices' normals, colours and texture
/// coordinates; the camera of the options as a node (see gltf/glb_camera.h).
MeshWriteResult write_glb(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
