// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {

/// Two corners that are seen at one place were taken for one vertex; its strokes contradict each other then. The
/// drawing's vertices with those divided that fit much better so: every part has three ends or more, as corners of
/// solids have, and no two strokes that would lie on each other. None where nothing is to be divided. Vertices that
/// strokes name stay, as do those of more than nine ends. Up to two hundred solves for each vertex of six ends or more.
/// @param groups what each stroke is taken for
/// @throws Cancelled
std::optional<DrawingVertices> with_split_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                                   const CameraEstimate& camera, std::span<const StrokeGroup> groups,
                                                   const CoordinateOptions& options, Progress& progress);

}  // namespace croquis
