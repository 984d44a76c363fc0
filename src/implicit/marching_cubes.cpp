// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/marching_cubes.h"

#include "implicit/cube_mesh.h"
#include "implicit/point_checks.h"
#include "implicit/sparse_lattice.h"
#include "implicit/surface_search.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t most_cells = 500'000'000;  // their vertices and corners have 32-bit numbers
constexpr int farthest_reach = 16;

}  // namespace

void require_polygonizer(const PolygonizerOptions& options) {
  require_parameter(options.max_cells <= most_cells, "max-cells", "at most 500000000 cubes are possible");
  require_parameter(options.seed_reach >= 0 && options.seed_reach <= farthest_reach, "seed-reach",
                    "it must lie between 0 and 16 cubes");
}

Polygonized polygonize(const Field& field, std::span<const Vec3> seeds, const PolygonizerOptions& options,
                       Progress& progress) {
  require_polygonizer(options);
  Polygonized result;
  SparseLattice lattice(options.origin, options.cell, options.bounds);
  Progress searching = progress.step("search", 0.8);
  SurfaceSearch(lattice, field, options, result).run(seeds, searching);
  Progress meshing = progress.step("mesh", 0.2);
  make_cube_mesh(lattice, options, result, meshing);
  result.bytes = lattice.bytes() + result.mesh.positions.capacity() * sizeof(Vec3) +
                 (result.mesh.corners.capacity() + result.mesh.face_offsets.capacity()) * sizeof(Index);
  return result;
}

}  // namespace croquis::implicit
