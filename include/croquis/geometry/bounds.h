// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Least and greatest coordinates, model units; none of what has no points.
using BoundingBox = std::optional<std::array<Vec3, 2>>;

/// Of all vertices, used or not.
BoundingBox bounds_of(const PolyMesh& mesh);

/// Of all samples, in space.
BoundingBox bounds_of(const Drawing& drawing);

}  // namespace croquis
