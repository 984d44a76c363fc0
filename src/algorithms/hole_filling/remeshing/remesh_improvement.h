// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/hole_filling/remesh.h"
#include "croquis/implicit/field.h"

namespace croquis::hole_filling {

struct ImprovementOptions {
  double cell = 0;                          ///< model units
  int smoothing = 2;                        ///< rounds
  int refine = 0;                           ///< rounds of 1-to-4 splits at most
  double chord = 0;                         ///< ends them, model units; 0: never
  double snap = 0;                          ///< distance, model units; 0: none
  Precision precision = Precision::Double;  ///< of the coordinates
  int threads = 0;
};

/// Brings cubes' triangles to the surface: smoothing and projection in turns (Yoo 2005, eq. 9), vertices given are
/// kept where they are near (snap), then every triangle is cut in four where so asked. After each step what cuts
/// through itself goes back to where it was before: the cubes' own triangles never do.
/// Borders stay where they are.
/// @param mesh triangles; @param field with gradients for projection; @param points that vertices may snap to
/// @return pairs of triangles that intersect all the same
/// @throws Cancelled
std::size_t improve(PolyMesh& mesh, const implicit::Field& field, std::span<const Vec3> points,
                    const ImprovementOptions& options, Progress& progress);

/// Moves vertices back, about pairs of triangles that intersect and in growing rings around them, until none do.
/// @param before positions of all vertices at which nothing intersects
/// @return pairs that intersect all the same
std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, int threads, Progress& progress);

}  // namespace croquis::hole_filling
