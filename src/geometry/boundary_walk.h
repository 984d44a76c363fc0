// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/mesh_topology.h"

namespace croquis {

/// The rims of a mesh as MeshTopology::boundary_loops describes them.
/// @param topology complete except for its loops
IndexTable trace_boundary_loops(const MeshTopology& topology);

}  // namespace croquis
