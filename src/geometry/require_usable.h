// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Lets any soup pass that can be computed with.
/// @throws Error (E_INDEX, E_NOT_FINITE) with every finding of `validate` of these kinds
void require_usable(const PolyMesh& mesh);

}  // namespace croquis
