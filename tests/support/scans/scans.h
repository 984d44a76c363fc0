// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// Surfaces as a scanner would leave them: analytic shapes, whole or with pieces missing, so that what is missing is
/// known. Cutting removes faces alone: vertices keep their numbers, some without a face.
namespace croquis::test {

/// Triangles of an icosahedron divided `levels` times, on the unit sphere: 20 × 4^levels.
PolyMesh round_sphere(int levels);

/// Triangles of a profile (radius, height), first to last, turned around z; radius 0 at an end closes it in a pole,
/// else that end is open. The outside is to the right of the profile.
PolyMesh revolved(std::span<const Vec2> profile, Index segments);

PolyMesh open_tube(double radius, double length, Index segments, Index rings);
PolyMesh bowl(Index segments, Index rings);        ///< the lower half of the unit sphere
PolyMesh bust(Index segments, Index rings);        ///< a head on a neck on shoulders, open below, 2 high
PolyMesh sheet(Index columns, Index rows);         ///< triangles, unit squares, in z = 0
PolyMesh divided_box(Index n);                     ///< [0,1]^3, each side n × n squares of two triangles
PolyMesh shell(int levels, double wall);           ///< unit sphere and one inside it that looks inwards
PolyMesh ring_torus(Index segments, Index sides);  ///< triangles of torus()

/// A mesh with pieces missing.
struct CutScan {
  PolyMesh complete;
  PolyMesh mesh;                            ///< without the removed faces
  std::vector<std::vector<Index>> removed;  ///< faces of `complete` per hole, ascending
};

/// Removes the piece of connected faces with all corners nearer to `centre` than `radius` that lies nearest to it.
CutScan cut(const PolyMesh& complete, const Vec3& centre, double radius);

/// Removes `count` pieces at random, each a disc with one simple rim, all apart from each other and from borders.
/// @param low, high radii in which pieces lie, model units
CutScan random_cuts(const PolyMesh& complete, std::uint64_t seed, std::size_t count, double low, double high);

/// Removes the ring between two radii: a hole with an island in it.
CutScan cut_ring(const PolyMesh& complete, const Vec3& centre, double inner, double outer);

/// A sheet with `count` holes in a row, each sharing a corner with the next.
PolyMesh chained_holes(Index count);

/// Every vertex on a rim moved by up to `amount` × its shortest edge.
PolyMesh with_noisy_rims(PolyMesh mesh, std::uint64_t seed, double amount);

/// Each face with corners of its own, as STL files have them.
PolyMesh as_soup(const PolyMesh& mesh);

}  // namespace croquis::test
