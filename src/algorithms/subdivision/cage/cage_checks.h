// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/cage.h"

/// What a mesh lacks to be a cage, in sentences. Of findings of one code that name one element each the first hundred
/// are kept.
namespace croquis::subdivision {

/// E_INDEX, E_NOT_FINITE, E_FACE_DEGENERATE. The first kind leaves nothing to look at further.
Findings check_values(const PolyMesh& mesh);

/// E_EDGE_SHARED
void check_sharing(const MeshTopology& topology, Findings& findings);

/// E_NOT_ORIENTABLE
/// @param conflicts corners at whose edges the faces can't agree
void check_orientable(const MeshTopology& topology, const std::vector<Index>& conflicts, Findings& findings);

/// W_FLIPPED, all in one
void report_flipped(const std::vector<Index>& faces, Findings& findings);

/// W_BOWTIE, W_LOOSE_VERTEX
void report_fans(const MeshTopology& topology, Findings& findings);

/// W_MAY_FOLD
void report_reflex_corners(const PolyMesh& mesh, Findings& findings);

/// Puts the mesh's tags onto the cage, whose topology is complete; W_TAG_NO_EDGE, W_TAG_SHARPNESS.
/// @param cage_corner #C of the mesh -> half-edge of the cage
void read_sharpness(const PolyMesh& mesh, const MeshTopology& topology, const std::vector<Index>& cage_corner,
                    Cage& cage, Findings& warnings);

/// Puts the mesh's pins onto the cage, whose sharpness is known; W_PIN_NO_EFFECT.
void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings);

/// W_TAG_VANISHES: edges that are sharp alone and retract at both ends.
void report_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings);

}  // namespace croquis::subdivision
