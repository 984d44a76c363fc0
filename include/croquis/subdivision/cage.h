// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/half_edges.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// The vertex channel (8 bits, 0 or 1) that marks which corners of a mesh an earlier refinement made.
inline constexpr const char* settled_channel = "settled_corner";

/// What subdivision starts from: a control mesh with its tags, checked.
///
/// Faces are those of the mesh given, in its order, all with the same orientation. A vertex where several fans of faces
/// meet is one vertex per fan; vertices without faces are left out. Else vertices keep their numbers. A cage without
/// faces is a cage.
struct Cage {
  std::vector<Vec3> positions;  ///< #V
  HalfEdges topology;
  std::vector<double> sharpness;      ///< #E, 0 … greatest_sharpness, or infinite_sharpness
  std::vector<std::uint8_t> pinned;   ///< #V, 1 for vertices that stay where they are
  std::vector<std::uint8_t> settled;  ///< #V, 1 for corners that an earlier refinement made
  std::vector<Index> source_vertex;   ///< #V -> vertex of the mesh given
  std::vector<Index> flipped_faces;   ///< ascending; turned over to agree with their neighbours
};

struct CageResult {
  Cage cage;
  Findings warnings;
};

/// Whose tags are read: a pin without a sharp edge does nothing in Doo-Sabin, and holds its vertex in the others.
enum class CageUse { DooSabin, UniformSchemes };

/// Reads a mesh and its tags (PolyMesh::tags) as a cage.
///
/// Repaired with a warning: faces with the wrong orientation (W_FLIPPED, of each connected part the fewer), vertices
/// with several fans (W_BOWTIE), vertices without faces (W_LOOSE_VERTEX). Refused with a warning, the others kept: tags
/// between vertices that no edge joins (W_TAG_NO_EDGE), sharpness that is negative or NaN (W_TAG_SHARPNESS); more than
/// greatest_sharpness counts as infinite. Reported: pins that change nothing (W_PIN_NO_EFFECT), faces with reflex
/// corners (W_MAY_FOLD), single tagged edges that shrink away (W_TAG_VANISHES, where rules.chain_ends retract). Tags on
/// boundary edges are fine and change nothing: boundaries are sharp anyway. Linear time for bounded valences.
/// @throws Error with all of E_INDEX, E_NOT_FINITE (malformed), E_FACE_DEGENERATE, E_EDGE_SHARED, E_NOT_ORIENTABLE
CageResult make_cage(const PolyMesh& mesh, const Rules& rules = {}, CageUse use = CageUse::DooSabin);

}  // namespace croquis::subdivision
