// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/drawing_vertices.h"
#include "croquis/perspective/network_reconstruction.h"
#include "support/perspective/solid_drawing.h"

/// Compares what was found in a drawing with what it shows.
namespace croquis::test {

/// For each vertex of the drawing the one of the solid; no_index for those of links alone.
std::vector<Index> true_vertices(const SolidDrawing& truth, const PerspectiveDrawing& drawing,
                                 const DrawingVertices& vertices);

/// Diagonal of the solid's bounding box.
double true_diagonal(const SolidDrawing& truth);

/// Largest distance from the truth, × diagonal.
double greatest_error(const SolidDrawing& truth, const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                      const std::vector<Vec3>& positions);

/// Root mean square distance after the best scale and translation, × diagonal.
double shape_error(const SolidDrawing& truth, const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                   const std::vector<Vec3>& positions);

/// How many different coordinates there are, bit by bit, and in truth.
std::size_t count_planes(const std::vector<Vec3>& positions);
std::size_t count_true_planes(const SolidDrawing& truth);

/// With default options.
ReconstructedNetwork reconstructed(const PerspectiveDrawing& drawing, const NetworkReconstructionOptions& options = {});

/// Of findings, in their order.
std::vector<std::string> codes_of(const Findings& findings);

/// The middle one.
double median(std::vector<double> values);

/// A straight construction stroke.
PerspectiveStroke construction(const std::string& id, StrokeGroup group, const Vec2& a, const Vec2& b);

/// The same drawing enlarged around the origin, then moved.
PerspectiveDrawing scaled_and_moved(PerspectiveDrawing drawing, double scale, const Vec2& move);

/// In another order, some strokes drawn the other way round, with other ids.
PerspectiveDrawing shuffled_and_renamed(PerspectiveDrawing drawing, std::uint64_t seed);

}  // namespace croquis::test
