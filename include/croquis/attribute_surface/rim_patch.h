// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

/// Holes of meshes closed by attribute surfaces: the rim becomes the curves of one face, the mesh's normals along it
/// their slopes.
namespace croquis {

struct RimPatchOptions {
  double corner = 40 * std::numbers::pi / 180;  ///< radians, 0..pi: rims that turn more, beyond what a circle of as
                                                ///< many edges does, have a corner there
  std::size_t sides = 0;           ///< 3..12; 0: as many as there are corners, 4 where these are fewer than 3, and
                                   ///< more where the surface would fold
  bool smooth = true;              ///< common tangent planes with the mesh around; else a crease
  std::optional<double> fullness;  ///< -1..2; none: so that the middle is as high as the rim lets expect
  double density = 1;              ///< 0.1..10, × as long edges as the rim's: smaller is finer
};

/// What became of a rim.
struct RimOutcome {
  bool closed = false;
  std::string reason;          ///< why not; empty where it is closed
  std::size_t sides = 0;       ///< of the face
  std::size_t first_face = 0;  ///< of the mesh
  std::size_t face_count = 0;  ///< triangles
  double curve_distance = 0;   ///< model units: how far the rim is from its curves
};

struct RimPatches {
  PolyMesh mesh;                     ///< the one given, with new vertices and triangles behind its own
  std::vector<RimOutcome> outcomes;  ///< one for each rim
};

/// Closes holes. Vertices and faces of the mesh stay as they are, bit for bit; patches use its rims' vertices and turn
/// as its faces do. Where a curve misses the rim, the surface near the rim follows the rim, less and less away from it,
/// so that there is no step. A rim stays open, with its reason, where its faces don't agree in direction, where its
/// vertices have no normals, and where its patch would cut through itself or the mesh.
/// New elements have no values in the mesh's channels: NaN, or 0 where the type has none.
/// @param mesh valid
/// @param rims loops of boundary vertices, each in the direction of the mesh's faces (MeshTopology::boundary_loops)
/// @throws Cancelled
RimPatches patch_rims(const PolyMesh& mesh, std::span<const std::vector<Index>> rims, const RimPatchOptions& options,
                      Progress& progress);

}  // namespace croquis
