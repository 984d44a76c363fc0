// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::test {

/// Divides the triangles of a closed mesh on a solid's surface where it was seen from nearby: their number per area
/// varies smoothly up to `ratio` times. Always a triangle's longest edge is cut (Rivara 1984), so that no angle gets
/// less than half as wide; new vertices lie on the surface.
/// @param triangles wanted, within 25 %; more than the mesh has, and less than `ratio` times as many
PolyMesh with_uneven_density(PolyMesh mesh, const std::function<double(const Vec3&)>& solid, std::uint64_t seed,
                             std::size_t triangles, double ratio);

}  // namespace croquis::test
