// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::hole_filling {

/// A closed border of a piece of surface.
struct BorderLoop {
  std::vector<Index> vertices;  ///< in the direction of the triangles, which lie on their left
  Index component = 0;          ///< of MeshTopology
};

/// The triangles none of whose corners is left out, as a mesh without unused vertices. Its borders are simple:
/// triangles with two border edges are removed, and those around vertices where borders touch, until there are none.
/// @param triangles manifold and consistently oriented; @param left_out #V
PolyMesh open_sheet(const PolyMesh& triangles, std::span<const std::uint8_t> left_out);

std::vector<BorderLoop> border_loops(const PolyMesh& sheet);

/// Only those components that are wanted, without unused vertices; the order of vertices and faces stays.
/// @param wanted per component of MeshTopology
PolyMesh components_of(const PolyMesh& sheet, const std::vector<bool>& wanted);

}  // namespace croquis::hole_filling
