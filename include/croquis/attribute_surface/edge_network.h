// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <span>

#include "croquis/base/progress.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

struct EdgeNetworkOptions {
  double tolerance = 0.002;  ///< × diagonal of the mesh's box, > 0: how far curves may be from the edges' vertices
  double corner = 40 * std::numbers::pi / 180;  ///< radians, 0..pi: rows of edges that turn more have a corner there
  bool slopes = false;  ///< the mesh's normals along the curves, so that faces of the network continue it smoothly
};

/// The vertices of an edge in any order.
using EdgeEnds = std::array<Index, 2>;

/// Edges of a mesh as curves of an attribute network; it has no faces yet.
///
/// Rows of edges run between vertices where one, three or more of them meet, and corners; rows that come back to where
/// they began are cut into 4 about equal parts. Nodes are at vertices bit for bit and called after them ("v17"), curves
/// "e0", "e1" … and, where a row takes several, "e0/1" …. Slopes are normals of the faces around, carried on linearly
/// to the edge (see rim_normal).
/// @param mesh  valid
/// @param edges pairs of different vertices of the mesh, joined by a face or not; each counts once
/// @throws Error (E_NO_EDGES) without edges
/// @throws Cancelled
AttributeNetwork network_of_edges(const PolyMesh& mesh, std::span<const EdgeEnds> edges,
                                  const EdgeNetworkOptions& options, Progress& progress);

}  // namespace croquis
