// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_report.h"

namespace croquis::cli {

/// Everything that keeps a mesh from being a solid, not only the first thing; empty for a solid.
/// @param report with self-intersections counted
/// @param file   how the sentences call the mesh
Findings solid_faults(const MeshReport& report, const std::string& file);

}  // namespace croquis::cli
