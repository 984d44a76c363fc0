// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/marching_cubes.h"

#include <limits>
#include <utility>

#include "croquis/implicit/slab_polygonizer.h"
#include "implicit/point_checks.h"
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
  const SlabOptions one_slab = {2, std::numeric_limits<std::size_t>::max()};
  SlabPolygonized found = polygonize_by_slabs(field, seeds, options, one_slab, {}, progress);
  Polygonized result = std::move(found.report);
  PolyMesh& mesh = result.mesh;
  mesh.positions = std::move(found.made.positions);
  mesh.corners = std::move(found.made.corners);
  mesh.face_offsets.resize(mesh.corners.size() / 3 + 1);
  for (std::size_t f = 0; f < mesh.face_offsets.size(); ++f) mesh.face_offsets[f] = static_cast<Index>(3 * f);
  result.covered = std::move(found.made.covered);
  result.bytes = found.most_bytes + mesh.positions.capacity() * sizeof(Vec3) +
                 (mesh.corners.capacity() + mesh.face_offsets.capacity()) * sizeof(Index);
  return result;
}

}  // namespace croquis::implicit
