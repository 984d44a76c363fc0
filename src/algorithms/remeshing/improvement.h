// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/implicit/field.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// A field that vertices are brought onto.
struct ImprovedField {
  implicit::Field field;  ///< with gradients for projection
  int axis = 0;           ///< along which the mesh' vertices come, about

  /// Called when the field is hardly needed any more below a place along the axis. May be empty.
  std::function<void(double place)> forget_below;
};

/// Brings cubes' triangles to the surface: smoothing and projection in turns (Yoo 2005, eq. 9), vertices given are
/// kept where they are near (snap), then every triangle is cut in four where so asked. After each step what cuts
/// through itself goes back to where it was before: the cubes' own triangles never do.
/// Borders stay where they are.
/// @param mesh triangles; @param points that vertices may snap to; @param cell of the cubes, model units
/// @return pairs of triangles that intersect all the same
/// @throws Cancelled
std::size_t improve(PolyMesh& mesh, const ImprovedField& field, std::span<const Vec3> points,
                    const RemeshOptions& options, double cell, Progress progress);

/// Moves vertices back, about pairs of triangles that intersect and in growing rings around them, until none do.
/// @param before positions of all vertices at which nothing intersects
/// @return pairs that intersect all the same
/// @throws Cancelled
std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, int threads, Progress progress);

/// The same where only some vertices were moved, which makes it faster. @param moved ascending
std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, std::span<const Index> moved,
                           Progress progress);

/// Pairs of triangles that intersect, as find_self_intersections has them, (low, high), ascending, on several threads.
/// A million of them at most for each sixteenth of the mesh.
/// @throws Cancelled
std::vector<std::array<Index, 2>> find_cuts(const PolyMesh& mesh, int threads, Progress progress);

}  // namespace croquis::remeshing
