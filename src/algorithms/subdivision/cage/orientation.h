// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "algorithms/subdivision/cage/edge_pairing.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::subdivision {

struct Orientation {
  std::vector<bool> flipped;                         ///< #F; of each connected part the fewer, on a tie not its first
  std::vector<std::array<Index, 2>> contradictions;  ///< an edge of each part that can't be oriented
};

/// Flips faces until neighbours agree: flood fill across edges of exactly two faces. Linear time.
Orientation orient(const PolyMesh& mesh, const EdgePairing& pairing);

}  // namespace croquis::subdivision
