// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/implicit/field.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

struct ImprovementOptions {
  double cell = 0;                                                      ///< model units
  int smoothing = 2;                                                    ///< rounds
  int refine = 0;                                                       ///< rounds of 1-to-4 splits at most
  double chord = 0;                                                     ///< ends them, model units; 0: never
  double snap = 0;                                                      ///< distance, model units; 0: none
  hole_filling::Precision precision = hole_filling::Precision::Double;  ///< of the coordinates
  int threads = 0;
};

/// A field that vertices are brought onto.
struct ImprovedField {
  implicit::Field field;  ///< with gradients for projection
  int axis = 0;           ///< along which the mesh' vertices come, about

  /// Called when the field is hardly needed any more below a place along the axis. May be empty.
  std::function<void(double place)> forget_below;
};

/// Projects points, in parts that can be cancelled. @param fixed per point, or none
/// @return the greatest distance that a point moved
double onto_surface(std::span<Vec3> points, std::span<const std::uint8_t> fixed, const ImprovedField& field,
                    const ImprovementOptions& options, Progress& progress);

/// Brings cubes' triangles to the surface: smoothing and projection in turns (Yoo 2005, eq. 9), vertices given are
/// kept where they are near (snap), then every triangle is cut in four where so asked. After each step what cuts
/// through itself goes back to where it was before: the cubes' own triangles never do.
/// Borders stay where they are.
/// @param mesh triangles; @param points that vertices may snap to
/// @return pairs of triangles that intersect all the same
/// @throws Cancelled
std::size_t improve(PolyMesh& mesh, const ImprovedField& field, std::span<const Vec3> points,
                    const ImprovementOptions& options, Progress& progress);

/// The same when smoothing is done.
/// @param mesh with positions as the cubes have them @param smooth those after smoothing
std::size_t improve_smoothed(PolyMesh& mesh, std::vector<Vec3> smooth, const ImprovedField& field,
                             std::span<const Vec3> points, const ImprovementOptions& options, Progress& progress);

/// Moves vertices back, about pairs of triangles that intersect and in growing rings around them, until none do.
/// @param before positions of all vertices at which nothing intersects
/// @return pairs that intersect all the same
std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, int threads, Progress& progress);

/// The same where only some vertices were moved, which makes it faster. @param moved ascending
std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, std::span<const Index> moved,
                           Progress& progress);

}  // namespace croquis::remeshing
