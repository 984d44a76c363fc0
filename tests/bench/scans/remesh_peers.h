// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bench/scans/meshlab_server.h"

namespace croquis::bench {

/// MeshLab's "Screened Poisson" (Kazhdan, Hoppe 2013) of the vertices and their normals, by meshlabserver.
/// @param depth of the octree
/// @return nothing when it failed or isn't installed
std::optional<MeshlabRun> meshlab_poisson(const PolyMesh& mesh, int depth);

}  // namespace croquis::bench
