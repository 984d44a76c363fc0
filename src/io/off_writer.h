// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// OFF with whatever of vertex normals, colours, texture coordinates and face colours the mesh has.
MeshWriteResult write_off(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
