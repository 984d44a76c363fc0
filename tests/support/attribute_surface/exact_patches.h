// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "croquis/geometry/attribute_network.h"

/// Faces cut out of known surfaces, so that it can be said how far a surface of their boundary alone is off.
namespace croquis::test {

/// A surface that can tell the place nearest to any point near it.
using NearestOnSurface = std::function<Vec3(const Vec3&)>;

struct ExactPatch {
  AttributeNetwork network;  ///< one face, named after the patch; curves are within 1e-10 of the surface
  NearestOnSurface nearest;
};

/// From a sphere: `octant`, `wedge` (20 degrees), `skinny obtuse`, `sphere pentagon`; from a torus: `torus triangle`,
/// `torus quad` (4:1); from the saddle z = x y: `saddle triangle`, `saddle quad` (nearly a square, over which it is
/// bilinear); from a hood, a height that is round both ways: `hood triangle`, `hood trapezoid`, `hood pentagon`.
std::vector<ExactPatch> exact_patches();

/// The surfaces: the unit sphere around the origin, a torus of radii 2 and 0.8 around z, the saddle and the hood.
Vec3 nearest_on_sphere(const Vec3& point);
Vec3 nearest_on_torus(const Vec3& point);
Vec3 nearest_on_saddle(const Vec3& point);
Vec3 nearest_on_hood(const Vec3& point);

/// A place of the torus; angles in radians, around the axis and around the tube.
Vec3 torus_place(double around, double tube);

/// The shorter great circle between two unit vectors, t in 0..1.
Vec3 great_circle(const Vec3& from, const Vec3& to, double t);

}  // namespace croquis::test
