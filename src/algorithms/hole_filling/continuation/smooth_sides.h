// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/hole_filling/continuation/known_surface.h"

namespace croquis::hole_filling {

/// A part of the surface around a hole that is bounded by creases.
struct SmoothSide {
  std::vector<Index> vertices;  ///< of the known surface, ascending: nearest to the rims first
  std::vector<Vec3> normals;    ///< unit, of this side's triangles alone
};

/// The parts that have an edge on a rim and four triangles at least. A crease that ends somewhere separates nothing.
/// n log n.
std::vector<SmoothSide> smooth_sides(const KnownSurface& known);

}  // namespace croquis::hole_filling
