// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/implicit/marching_cubes.h"

/// Functions whose zero sets are known; distances where not said otherwise. Negative inside.
namespace croquis::test {

double sphere_at(const Vec3& p, const Vec3& centre, double radius);
double torus_at(const Vec3& p, double radius, double tube);  ///< around z
double ellipsoid_at(const Vec3& p, const Vec3& half_axes);   ///< zero set alone; slope about 1
double gyroid_at(const Vec3& p);                             ///< sin x cos y + sin y cos z + sin z cos x

/// A sphere of radius 1 with a shell of that thickness, cut by a cylinder of radius 0.4 along z: a thin sheet with
/// sharp edges, of genus 1.
double pierced_shell_at(const Vec3& p, double thickness);

/// Cubes in [-reach, reach]^3.
implicit::PolygonizerOptions within(double reach, double cell, int seed_reach = 1);

}  // namespace croquis::test
