// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/perspective/coordinates/class_solution.h"
#include "croquis/base/progress.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {

/// How well everything else fits without a stroke.
struct StrokeSuspicion {
  Index stroke = no_index;
  double rms = 0;  ///< u, over the degrees of freedom that are left
};

/// All that a solve depends on.
struct TiedVertices {
  SeenVertices seen;
  CoordinateTies ties;
};

/// A solve with all that it was made from.
struct SolvedVertices {
  ClassTable table;
  ClassSolution solution;

  std::vector<Vec3> positions() const;
};

/// @param near, rounds as for solve_classes
SolvedVertices solved(const TiedVertices& tied, const std::vector<Vec3>* near = nullptr, int rounds = 12);

/// The strokes that tie something.
std::vector<Index> tying_strokes(const CoordinateTies& ties);

/// Strokes by how well the rest fits without them, best first; the second is u.
std::vector<StrokeSuspicion> ranked_strokes(const TiedVertices& tied, const std::vector<Index>& strokes,
                                            Progress& progress);

/// Finds what contradicts the rest, one stroke after the other, and takes its group out of the ties. Promoted strokes
/// get their drawn group back first.
/// @param sigma u, noise of the drawing
/// @param drawn groups of all strokes as drawn
/// @param tied  groups are changed
std::vector<Contradiction> resolve_contradictions(TiedVertices& tied, std::span<const StrokeGroup> drawn, double sigma,
                                                  const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                                  const CoordinateOptions& options, Progress& progress);

/// The vertices of a drawing as its camera sees them, and what its strokes tie.
TiedVertices tied_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                           const CameraEstimate& camera, std::span<const StrokeGroup> groups);

}  // namespace croquis
