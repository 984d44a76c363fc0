// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::app {

/// How patches are coloured.
enum class PatchLook {
  Plain,      ///< as the rest of the surface
  Preview,    ///< distinct from all that is there
  Distinct,   ///< slightly distinct from the rest, as long as holes are worked on
  Confidence  ///< by their confidence
};

/// Faces of patches, taken out of a filled mesh: small, so that a change of them is seen at once on scans of any size.
struct PatchSurface {
  std::shared_ptr<const PolyMesh> mesh;  ///< with the scan's normals along rims, so that no seam is seen
  std::vector<std::int32_t> patch;       ///< #F, number of each face's patch
  bool completes = false;                ///< with the faces of the mesh that was filled this is the whole surface
};

/// The numbers of the faces' patches, -1 for those of none; null for a mesh without patches.
const std::vector<std::int32_t>* patch_ids(const PolyMesh& mesh);

/// The scan's vertices and faces come first in the mesh that was made by filling it, exactly as they were.
bool begins_with(const PolyMesh& filled, const PolyMesh& scan);

/// The patches of a filled mesh. @param wanted numbers of patches; null for all of them
/// @param scan that was filled, for `completes`; may be null
/// O(faces of the filled mesh), with little for those that aren't patches.
PatchSurface patches_of(const PolyMesh& filled, const PolyMesh* scan, const std::set<Index>* wanted = nullptr);

/// The same faces in the colours of a look.
std::shared_ptr<const PolyMesh> colored(const PatchSurface& patches, PatchLook look);

/// A whole filled mesh with its patches in the colours of a look: for one whose scan didn't stay as it was, since rims
/// were trimmed or the model was remeshed. Everything else of it keeps its colours.
std::shared_ptr<const PolyMesh> colored_whole(const std::shared_ptr<const PolyMesh>& filled, PatchLook look);

}  // namespace croquis::app
