// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/field.h"

namespace croquis::implicit {

/// Says of points of the surface whether they are covered by a surface that is there already. Thread-safe.
using Covered = std::function<void(std::span<const Vec3> points, std::span<std::uint8_t> covered)>;

struct PolygonizerOptions {
  double cell = 0;             ///< edge length of the cubes, model units, > 0
  Vec3 origin = Vec3::Zero();  ///< a corner of the lattice; equal origins and cells share their cubes bit by bit
  Box bounds;                  ///< cubes that stick out of it are never entered; at most 2^22 cubes per axis
  std::size_t max_cells = 50'000'000;  ///< cubes with surface at most; the search ends with the front that exceeds it

  /// The search ends as soon as it is known to be incomplete, for whatever reason, and gives no triangles then.
  bool only_complete = false;

  /// From every seed's cube this many cubes in all directions are looked at: 0 for seeds on the surface.
  int seed_reach = 1;

  /// The search doesn't leave a cube through a face all of whose crossings are covered. Empty: nothing is.
  Covered covered;

  int threads = 0;  ///< 0: as many as the machine has. The result is the same for any
};

/// A surface and how the search for it ended. Only with `complete()` is it all of what the seeds lead to.
struct Polygonized {
  PolyMesh mesh;                      ///< triangles, counter-clockwise seen from where the field is positive
  std::vector<std::uint8_t> covered;  ///< #V, or none without a predicate

  bool reached_bounds = false;     ///< surface leaves the box
  bool reached_max_cells = false;  ///< the limit ended the search
  bool reached_undefined = false;  ///< surface runs into places without a value
  bool complete() const { return !reached_bounds && !reached_max_cells && !reached_undefined; }

  std::size_t cells = 0;          ///< cubes with surface
  std::size_t visited_cells = 0;  ///< cubes looked at
  std::size_t evaluations = 0;    ///< of the field
  std::size_t rounds = 0;         ///< fronts of the search
  std::size_t bytes = 0;  ///< held by the search at its end, about 140 per cube with surface, 60 of them the mesh
};

/// Follows the surface F = 0 from cube to cube, beginning at the seeds, and gives its triangles.
///
/// Every cube's polygons come from the segments on its six faces; where a face is ambiguous the asymptotic decider
/// (Nielson, Hamann 1991) sees the face's own four values alone, so that the two cubes there agree and the surface has
/// no cracks: closed and manifold whenever `complete()` and nothing is covered. No diagonal lies in a face of a cube.
/// A value of exactly 0 counts as outside. Crossings are found by linear interpolation, at least 1e-4 of an edge away
/// from its ends so that no triangle is without area; `project` brings them to the surface itself.
/// Vertices and triangles are ordered by place: no seed's order, number or thread changes them, unless a limit is met.
/// Linear in the number of cubes with surface.
/// @param seeds places near every piece wanted; those outside the bounds are ignored
/// @throws Error (E_PARAMETER) for a cell or bounds that can't be used; Cancelled
Polygonized polygonize(const Field& field, std::span<const Vec3> seeds, const PolygonizerOptions& options,
                       Progress& progress);

}  // namespace croquis::implicit
