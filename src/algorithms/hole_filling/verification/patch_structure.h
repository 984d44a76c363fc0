// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/patch_verification.h"

namespace croquis::hole_filling {

/// A patch as a mesh of its own, with the view's vertices.
struct LocalPatch {
  PolyMesh mesh;
  std::vector<Index> vertices;  ///< sorted: vertex i is that vertex of the view, or #V + a new point's number
};

/// @param precision how coordinates will be stored
LocalPatch make_local(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch,
                      Precision precision = Precision::Double);

/// What is wrong with a patch's connectivity, its rims included, or nothing: see PatchVerifier.
/// @param precision how coordinates will be stored
std::string structure_fault(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch,
                            Precision precision = Precision::Double);

/// The inner edges of a patch between two vertices of the mesh, as pairs (low, high) of the view's vertices.
std::vector<std::array<Index, 2>> chords_of(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch);

/// Smallest corner angle, and greatest angle between faces across a rim edge. For patches without a structure fault.
PatchVerdict measure_patch(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch);

}  // namespace croquis::hole_filling
