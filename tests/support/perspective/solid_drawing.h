// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "croquis/geometry/camera.h"
#include "croquis/geometry/perspective_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

namespace croquis::test {

enum class Colouring {
  Axes,   ///< straight edges along an axis have that axis' colour
  Planes  ///< they have the colour of one of the two planes they lie in; only construction lines have axis colours
};

struct SolidDrawingOptions {
  double noise = 0;  ///< px, deviation of each coordinate: of a vertex as all its strokes draw it, of a handle, and
                     ///< of each end of a construction line
  double end_jitter = 0;       ///< px, further deviation of each coordinate of each stroke's end on its own
  int construction_lines = 3;  ///< for each axis
  bool vertex_ids = true;      ///< strokes say which vertices they join ("v0" …)
  bool links = true;           ///< construction strokes that tie the solid's pieces together
  bool known = true;           ///< one known point (vertex 0) and one known length
  bool hidden = false;         ///< edges whose faces both look away from the eye are marked
  bool shuffled = true;        ///< order and direction of strokes are random
  Colouring colouring = Colouring::Axes;
  std::uint64_t seed = 1;
};

/// A drawing and what it shows.
struct SolidDrawing {
  PerspectiveDrawing drawing;       ///< ids of edges are those of the curves; "c0" …: construction; "l0" …: links
  Camera camera;                    ///< the true one
  CurveNetwork network;             ///< the true curves, numbered as those of the solid
  std::vector<StrokeGroup> groups;  ///< of the curves as drawn
};

/// Draws a solid. Without noise the drawing is exact: every drawn cubic is what the true rational cubic looks like, at
/// the same parameter. A polynomial cubic would look like a rational one, so true curves have the solid's control
/// points with weights 1 / depth; planes, ends and tangents stay.
SolidDrawing drawn(const PerspectiveSolid& solid, const Camera& camera, const SolidDrawingOptions& options = {});

/// With the view's own camera and sheet.
SolidDrawing drawn(const PerspectiveSolid& solid, const View& view, const SolidDrawingOptions& options = {});

}  // namespace croquis::test
