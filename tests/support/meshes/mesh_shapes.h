// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Geometry>

#include "croquis/geometry/poly_mesh.h"

/// Meshes whose figures are known by counting. All closed ones are oriented outwards.
namespace croquis::test {

PolyMesh tetrahedron();  ///< corners at the origin and the three axes' unit points: volume 1/6
PolyMesh cube();         ///< [0,1]^3, six quads
PolyMesh bent_box();     ///< the cube with its corner (1,1,1) raised to z = 2: volume 7/6, area 6.5 + √3/2

/// Radius 1 about the origin, the poles on z: 2 + n (m - 1) vertices, n m faces (triangles at the poles, else quads).
/// @param segments n >= 3, around; @param rings m >= 2, from pole to pole
PolyMesh uv_sphere(Index segments, Index rings);

/// Quads, n m vertices and faces; radius 1 around z, tube radius 0.4.
/// @param segments n >= 3, around z; @param sides m >= 3, around the tube
PolyMesh torus(Index segments, Index sides);

PolyMesh double_torus();  ///< a plate of 13 unit cubes with two holes: genus 2, V 48, E 100, F 50, volume 13
PolyMesh grid(Index columns, Index rows);  ///< open, unit quads in z = 0 facing up, the first corner at the origin
PolyMesh moebius(Index quads);       ///< a strip with half a turn, at least 3 quads: one boundary loop, not orientable
PolyMesh tetrahedra_sharing_edge();  ///< V 6, F 8: one edge with four faces
PolyMesh tetrahedra_sharing_vertex();  ///< V 7, F 8: one vertex with two fans

/// `count` triangles with corners of their own, uniform in the unit cube.
PolyMesh random_soup(std::uint64_t seed, Index count);

PolyMesh transformed(PolyMesh mesh, const Eigen::Affine3d& transform);
PolyMesh translated(PolyMesh mesh, const Vec3& offset);
PolyMesh scaled(PolyMesh mesh, double factor);
PolyMesh rotated(PolyMesh mesh, double radians, const Vec3& axis);

PolyMesh flipped(const PolyMesh& mesh);                 ///< every face turned over
PolyMesh flipped_face(PolyMesh mesh, Index face);       ///< one face turned over
PolyMesh triangulated(const PolyMesh& mesh);            ///< each face by the fan from its first corner
PolyMesh merged(const PolyMesh& a, const PolyMesh& b);  ///< both, sharing nothing
PolyMesh without_faces(const PolyMesh& mesh, std::span<const Index> faces);  ///< vertices stay

/// The same surface with vertices and faces in another order, and each face beginning at another corner.
PolyMesh shuffled(const PolyMesh& mesh, std::uint64_t seed);

}  // namespace croquis::test
