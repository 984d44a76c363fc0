// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/subdivision/cage/edge_pairing.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/cage.h"

namespace croquis::subdivision {

/// What reading tags needs of a mesh and its cage, whose topology is complete.
struct TagSource {
  const PolyMesh& mesh;
  const EdgePairing& pairing;
  const std::vector<Index>& cage_corner;  ///< #C of the mesh -> half-edge of the cage
};

/// Puts the mesh's tags onto the cage; W_TAG_NO_EDGE, W_TAG_SHARPNESS.
void read_sharpness(const TagSource& source, Cage& cage, Findings& warnings);

/// Puts the mesh's pins onto the cage, whose sharpness is known; W_PIN_NO_EFFECT.
void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings);

/// W_TAG_VANISHES: edges that are sharp alone and retract at both ends.
void tell_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings);

}  // namespace croquis::subdivision
