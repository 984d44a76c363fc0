// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {

/// The focal length of one-point perspective from two known lengths or more, one of them going into depth: depths are
/// in proportion to the focal length that was assumed, so squared lengths are linear in its square. None where the
/// lengths don't tell.
/// @param coordinates found with the camera's assumed focal length
/// @return px
std::optional<double> focal_from_lengths(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                         const VertexCoordinates& coordinates);

}  // namespace croquis
