// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::bench {

void write_ply(const PolyMesh& mesh, const std::string& path);

/// @throws Error when it can't be read
PolyMesh read_ply(const std::string& path);

}  // namespace croquis::bench
