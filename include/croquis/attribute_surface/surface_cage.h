// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

struct SurfaceCageOptions {
  std::size_t segments = 4;  ///< along a curve, of equal length: even, 2..64
};

/// A control mesh of quads for subdivision, over the faces that could be evaluated: as closed as the network is, with
/// the Euler number of its faces, edges and nodes.
///
/// A face of four sides becomes a grid, one of n sides n grids around its middle, one of two sides a grid between its
/// nodes and the middles of its curves. Vertices lie on the surface. Faces that are joined run the same way. Curves in
/// which two faces meet at an angle are infinitely sharp, and vertices where two of these meet at a corner pinned;
/// smooth curves have no tags.
/// @pre segments is even and >= 2
/// @throws Cancelled
PolyMesh make_surface_cage(const AttributeNetwork& network, const AttributeSurface& surface,
                           const SurfaceCageOptions& options, Progress& progress);

}  // namespace croquis
