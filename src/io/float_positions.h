// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/io/mesh_file.h"

namespace croquis {

/// Each coordinate rounded to the nearest 32-bit float, infinite when it is too large.
Vec3 as_floats(const Vec3& point);

/// Floats hold every position exactly.
bool positions_are_floats(const PolyMesh& mesh);

/// The positions as 32-bit floats.
/// @throws Error (E_OUT_OF_RANGE) when one is too large for them
std::vector<Vec3> positions_as_floats(const PolyMesh& mesh, MeshFormat format);

}  // namespace croquis
