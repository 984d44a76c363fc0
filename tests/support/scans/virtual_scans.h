// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numbers>
#include <span>

#include "croquis/geometry/poly_mesh.h"
#include "support/random.h"
#include "support/scans/scans.h"
#include "support/scans/sculptures.h"

/// What scanning does to a complete mesh: pieces go missing, places are wrong, several views lie upon each other.
namespace croquis::test {

/// The diagonal of the box of all vertices with a face.
double diagonal_of(const PolyMesh& mesh);

/// Of triangles.
double mean_edge_of(const PolyMesh& mesh);

/// Of a normal distribution around 0 with a standard deviation of 1 (Box and Muller).
double normal_deviate(Random& random);

struct RaggedCuts {
  std::uint64_t seed = 1;
  std::size_t count = 12;          ///< of holes; fewer, where no more find room
  double low = 0.01, high = 0.08;  ///< radii, × diagonal, evenly by their logarithm
  double raggedness = 0.3;         ///< how much a radius varies along a rim, as fraction
  double island = 0;               ///< radius of a piece that stays inside, × the hole's; 0: none
};

/// Removes pieces at random, all apart from each other: irregular discs with one simple rim, or rings around an island.
/// Linear in faces plus the pieces.
CutScan ragged_cuts(const PolyMesh& complete, const RaggedCuts& cuts);

/// Removes the ragged piece around the place on the mesh nearest to `centre`, but for an island.
/// @param radius, island model units; @param seed of the rim's shape
PolyMesh cut_ragged(const PolyMesh& mesh, const Vec3& centre, double radius, double island, std::uint64_t seed);

/// Vertices moved along their normals by a normal distribution.
/// @param amount its standard deviation, × the mean edge
PolyMesh with_noise(PolyMesh mesh, std::uint64_t seed, double amount);

/// Faces that scanners far away see: turned to one of them by less than `greatest_angle`, and not hidden. The others
/// are missing, per connected piece of six faces at least; kept pieces of less than fifty faces are dropped, too.
/// @param directions towards the scanners
CutScan seen_from(const PolyMesh& complete, std::span<const Vec3> directions,
                  double greatest_angle = std::numbers::pi * 75 / 180);

/// One sheet per scanner, each a grid of depths across its view, triangulated where depth doesn't jump: raw borders,
/// sheets upon each other and joined nowhere.
/// @param spacing of the grids, model units
PolyMesh range_images(const PolyMesh& complete, std::span<const Vec3> directions, double spacing);

/// Vertices without a face go, the others keep their order. Channels are not carried.
PolyMesh without_loose_vertices(const PolyMesh& mesh);

}  // namespace croquis::test
