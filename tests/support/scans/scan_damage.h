// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "support/random.h"

/// What is wrong with scans beside what they lack. Faces given keep their order and their corners; what is added comes
/// behind.
namespace croquis::test {

/// Every face has its vertices to itself and to the others of its label: cracks of width 0 between labels.
/// @param labels one per face
/// @return #V of the result, the label of each vertex
std::vector<Index> split_between(PolyMesh& mesh, std::span<const Index> labels);

/// Coordinates one step of double precision up or down, by lot: seams that don't quite agree.
/// @param is_moved per vertex
void misplace_last_bits(PolyMesh& mesh, Random& random, const std::vector<bool>& is_moved);

/// Vertices moved along their normals: half of it in lumps as long as 4 to 12 mean edges, half vertex by vertex.
/// @param amount standard deviation, × mean edge; of the latter half × the mean edge around the vertex, since what was
/// seen from nearby was seen better
void add_lumps(PolyMesh& mesh, Random& random, double amount);

/// Vertices moved along one direction, by steps and by noise, as a scanner's depth is wrong.
/// @param amount of both, model units
void add_depth_noise(PolyMesh& mesh, Random& random, const Vec3& direction, double amount);

/// Little crumpled sheets and closed lumps that float in the air, in and around the box of the mesh, most of them near
/// its surface, never on it.
/// @param is_far tells whether a place is far enough from the surface
void add_floating_pieces(PolyMesh& mesh, Random& random, std::size_t count,
                         const std::function<bool(const Vec3&)>& is_far);

/// Triangles that hang into a hole, by an edge of its rim or (every third) by a corner.
/// @param rim corners that start the edges of the rim; where triangles hang, their free edges instead
/// @return how many
std::size_t add_stray_triangles(PolyMesh& mesh, Random& random, std::vector<Index>& rim, double share);

/// Triangles that stand on edges inside of the surface: edges of three faces.
void add_fins(PolyMesh& mesh, Random& random, std::size_t count);

}  // namespace croquis::test
