// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Faces without an area: fewer than 3 corners, a vertex used twice, or all corners on one line.
///
/// The test for a line is exact on the coordinates as given (no tolerance), so a needle however thin is not degenerate.
/// Indices must be in range and positions finite. Linear.
/// @return face indices, ascending
std::vector<Index> degenerate_faces(const PolyMesh& mesh);

}  // namespace croquis
