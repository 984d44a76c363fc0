// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// STL: triangles with the normals of their corners, binary with 32-bit floats or text.
MeshWriteResult write_stl(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
