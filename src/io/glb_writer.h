// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// Binary glTF 2.0: a node with a mesh for each object, of triangles by material (else by group) and of polylines as
/// lines, with normals, colours and texture coordinates (see gltf/glb_objects.h); the camera of the options as a node
/// (see gltf/glb_camera.h).
MeshWriteResult write_glb(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
