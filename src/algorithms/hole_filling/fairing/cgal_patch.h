// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

/// The only code that calls CGAL to fill holes.
namespace croquis::hole_filling {

using Triangle = std::array<Index, 3>;

/// The triangles of the points' Delaunay tetrahedra, of their plane's when they lie in one, none when in a line. Of
/// points at the same place one counts.
/// @return corners ascending, in an order that may be another one every time
std::vector<Triangle> cgal_delaunay_triangles(std::span<const Vec3> points);

/// Part of a mesh with a triangulated hole.
struct FairingInput {
  std::vector<Vec3> points;
  std::vector<Triangle> surroundings;  ///< faces around the hole: two rings for continuity 2, else one
  std::vector<Triangle> patch;         ///< oriented like the surroundings
  unsigned continuity = 1;             ///< 0: positions, 1: tangents, 2: curvatures agree at the rim
  double density = 0;  ///< CGAL's density control; larger is denser, sqrt(2) gives the rim's own density
  int rounds = 1;      ///< of fairing: each measures its weights on what the one before has made
};

struct FairingResult {
  std::vector<Vec3> new_points;  ///< numbered behind the input's
  std::vector<Triangle> patch;
};

/// Refines the patch (Liepa 2003, section 3) and moves its new vertices where the surface bends least
/// (Botsch et al., Polygon Mesh Processing, section 4.3, cotangent weights). Nothing when the surroundings aren't
/// manifold, the system is singular, a coordinate isn't finite, or CGAL throws.
/// @throws Cancelled between the steps
std::optional<FairingResult> cgal_refine_and_fair(const FairingInput& input, Progress& progress);

}  // namespace croquis::hole_filling
