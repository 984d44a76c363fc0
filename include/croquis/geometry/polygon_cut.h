// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// The one rule by which polygons are cut into triangles, for figures, files and pictures alike: a polygon that isn't
/// flat is another surface with every cut.
///
/// Ears are cut off along the shortest diagonal that lies inside the polygon, seen along its area normal. Lengths that
/// differ by less than a thousandth are equal; of equal ones that with the lowest vertex comes first. So the cut stays
/// the same when the polygon is moved, scaled or mirrored, when its numbers are rounded, and wherever its list of
/// corners begins. A polygon that crosses itself or has no area gets as many triangles, but merely some.
namespace croquis {

/// The corner of a quad, 0 or 1, from which its cut runs to the opposite corner.
std::size_t quad_cut(std::span<const Vec3> positions, std::span<const Index> quad);

/// Cuts a polygon of k >= 3 corners. O(k log k) where it is convex, O(k²) at worst.
/// @param positions of vertices
/// @param polygon   vertices, around it
/// @param avoid     whether two vertices should not be joined, where there is another way; empty: none
/// @return k - 2 triangles of corner numbers 0 .. k - 1, in the polygon's own sense of rotation
std::vector<std::array<Index, 3>> polygon_cut(std::span<const Vec3> positions, std::span<const Index> polygon,
                                              const std::function<bool(Index, Index)>& avoid = {});

/// Calls visit(triangle) with each triangle of a polygon's cut, as corner numbers; never for fewer than 3 corners.
template <typename Visit>
void visit_triangles(std::span<const Vec3> positions, std::span<const Index> polygon, const Visit& visit) {
  using Triangle = std::array<Index, 3>;
  if (polygon.size() < 3) return;
  if (polygon.size() == 3) {
    visit(Triangle{0, 1, 2});
  } else if (polygon.size() == 4) {
    const auto first = static_cast<Index>(quad_cut(positions, polygon));
    visit(Triangle{first, first + 1, first + 2});
    visit(Triangle{first, first + 2, (first + 3) % 4});
  } else {
    for (const Triangle& triangle : polygon_cut(positions, polygon)) visit(triangle);
  }
}

/// A mesh's faces as triangles.
struct MeshTriangles {
  std::vector<std::array<Index, 3>> corners;  ///< #T by 3, indices into PolyMesh::corners
  std::vector<Index> faces;                   ///< #T, the face each came from
};

MeshTriangles mesh_triangles(std::span<const Vec3> positions, const PolyMesh& mesh);

}  // namespace croquis
