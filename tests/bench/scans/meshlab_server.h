// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::bench {

/// What MeshLab made of a mesh.
struct MeshlabRun {
  PolyMesh mesh;
  double cpu_ms = 0;  ///< of its whole process
};

/// Runs a filter script by meshlabserver under xvfb-run, which gives it the GL context without which it aborts, from
/// file to file.
/// @return processor time of the server alone in ms; nothing when it failed or isn't installed
std::optional<double> run_meshlab_on_file(const std::string& script, const std::string& in, const std::string& out);

/// The same for a mesh, by files in a folder of its own.
std::optional<MeshlabRun> run_meshlab(const std::string& script, const PolyMesh& mesh);

}  // namespace croquis::bench
