// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::cli {

/// Everything that keeps a mesh from being a solid, not only the first fault; empty for a solid.
/// @param report with self-intersections counted
/// @param file   how the sentences call the mesh
Findings solid_faults(const MeshReport& report, const std::string& file);

/// A solid is judged by the numbers of its file: a format may round them until surfaces meet. Fills result.mesh.
/// @throws Error (E_ROUNDING)
void judge_solid(const std::string& path, const PolyMesh& written, CommandResult& result, Progress& progress);

/// Adds to the warnings what the mesh of result.mesh, with self-intersections counted, lacks for a solid:
/// W_SELF_INTERSECTION and, where it is meant to be closed, W_OPEN. Files for printing always are.
void warn_of_faults(const std::string& path, bool meant_closed, CommandResult& result);

}  // namespace croquis::cli
