// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"
#include "io/read_context.h"

namespace croquis {

/// What every format's result must hold beyond its syntax: faces unless they aren't asked for (E_NO_FACES), at least
/// vertices (E_EMPTY), points that differ (E_DEGENERATE). Faces that use a vertex twice are listed in one W_DEGENERATE
/// and kept: scans have them.
void check_mesh(const PolyMesh& mesh, bool require_faces, ReadContext& context);

}  // namespace croquis
