// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/subdivision/cage/edge_pairing.h"
#include "algorithms/subdivision/cage/orientation.h"
#include "algorithms/subdivision/cage/vertex_fans.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"

/// What a mesh lacks to be a cage, in sentences.
namespace croquis::subdivision {

/// E_INDEX, E_NOT_FINITE, E_FACE_DEGENERATE. The first kind leaves nothing to look at further.
Findings check_values(const PolyMesh& mesh);

/// #F: faces with fewer than three corners or repeated vertices.
std::vector<bool> degenerate_faces(const PolyMesh& mesh);

/// E_EDGE_SHARED
void check_sharing(const PolyMesh& mesh, const EdgePairing& pairing, Findings& findings);

/// E_NOT_ORIENTABLE
void check_orientable(const Orientation& orientation, Findings& findings);

/// W_FLIPPED, all in one
void tell_flipped(const std::vector<Index>& faces, Findings& findings);

/// W_BOWTIE, W_LOOSE_VERTEX
void tell_fans(const VertexFans& fans, Findings& findings);

/// W_MAY_FOLD
void tell_reflex_corners(const PolyMesh& mesh, Findings& findings);

}  // namespace croquis::subdivision
