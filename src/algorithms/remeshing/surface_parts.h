// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

/// Parts of a new surface, which is a mesh of triangles alone.
namespace croquis::remeshing {

/// Where the corners of a triangle are.
inline std::array<Vec3, 3> places_of(std::span<const Vec3> positions, std::span<const Index> triangle) {
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}
std::vector<std::array<Vec3, 3>> places_of(const PolyMesh& mesh);

/// Where all faces are triangles: the offsets that their corners imply.
void set_triangle_offsets(PolyMesh& mesh);

/// Of every vertex the lowest one that edges lead to.
std::vector<Index> parts_of(const PolyMesh& mesh);

/// Number of parts that edges join, vertices without triangles left out.
std::size_t part_count(const PolyMesh& mesh);

/// The mesh without some of its faces, and without the vertices that nothing uses then. Order stays.
PolyMesh without(const PolyMesh& mesh, std::span<const std::uint8_t> removed);

/// Removes faces that are marked; then those that hang on a border by one vertex or stick out of it by two edges, until
/// every vertex is manifold.
PolyMesh sound_without(const PolyMesh& mesh, std::vector<std::uint8_t> removed);

/// The same for triangles with a marked vertex.
PolyMesh trimmed(const PolyMesh& mesh, std::span<const std::uint8_t> beyond);

/// Points that no vertex is within `distance` of, ascending.
std::vector<Index> far_points(const PolyMesh& mesh, std::span<const Vec3> points, double distance, int threads,
                              Progress progress);

/// Points that no vertex of a surface is within 1.25 cells of, and how many of them are few.
std::vector<Index> lost_points(const PolyMesh& surface, std::span<const Vec3> points, double cell, int threads,
                               Progress progress);
bool are_few(std::size_t lost, std::size_t points);

/// Removes connected parts that are smaller than this, by the diagonal of their boxes, model units.
void drop_small(PolyMesh& mesh, double size);

/// Removes connected parts that hardly any point lies on. Parts that points do lie on stay, however many.
/// @return how many were removed
std::size_t drop_detached(PolyMesh& mesh, std::span<const Vec3> points, int threads, Progress progress);

}  // namespace croquis::remeshing
