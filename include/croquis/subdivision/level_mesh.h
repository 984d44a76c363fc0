// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/level.h"

namespace croquis::subdivision {

/// A level as a mesh of its own, with the tags that are left: subdividing it goes on where the level stopped.
/// @param positions #V of that level
PolyMesh to_mesh(const Level& level, std::span<const Vec3> positions);

/// The same with where its elements come from, as channels of 32-bit integers: per face "cage_kind" (labels "face",
/// "edge", "vertex", "band") and "cage_element", per vertex "cage_vertex". Elements are the cage's.
/// @param k 1 … plan.levels()
PolyMesh to_mesh(const DooSabinPlan& plan, int k, std::span<const Vec3> positions);

}  // namespace croquis::subdivision
