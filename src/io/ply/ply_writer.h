// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/mesh_file.h"

namespace croquis {

/// PLY with every channel as properties of its own type; polylines as edge elements.
MeshWriteResult write_ply(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
