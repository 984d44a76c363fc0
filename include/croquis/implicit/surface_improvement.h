// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/implicit/field.h"

namespace croquis::implicit {

struct ProjectionOptions {
  double cell = 0;              ///< h, model units, > 0: the scale of steps and accuracy
  double least_gradient = 0.2;  ///< |grad F| counts as at least this, so that steps stay bounded where it is flat
  double longest_step = 0.5;    ///< of h, per iteration
  double accuracy = 1e-6;       ///< of h: a shorter step ends the iteration
  int iterations = 20;          ///< at most
  int threads = 0;              ///< 0: as many as the machine has
};

struct ProjectionReport {
  std::size_t moved = 0;
  std::size_t not_converged = 0;  ///< points still moving when the iterations ended, or where the field has no value
  double largest_move = 0;        ///< model units
};

/// Moves points onto F = 0 along the gradient: x <- x - F g / max(|g|^2, least_gradient^2).
/// @param fixed #points, 1 where a point stays; or none
/// @throws Error (E_PARAMETER, E_COUNT)
ProjectionReport project(std::span<Vec3> points, std::span<const std::uint8_t> fixed, const Field& field,
                         const ProjectionOptions& options);

/// Every triangle cut in four at the middles of its edges: the old vertices keep their indices, the new ones follow in
/// the order of their edges' lower vertices. Channels of the mesh are not carried.
/// @param mesh triangles, any soup
/// @throws Error (E_NOT_TRIANGLES)
PolyMesh split_in_four(const PolyMesh& mesh);

}  // namespace croquis::implicit
