// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithms/silhouette/surface/inflation.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "support/sketches/sketch_tubes.h"

/// Labelled figures of known shape, made without the drawing steps: contours come from tubes in space, and what is
/// hidden below what is read off the tubes' heights.
namespace croquis::test {

/// A labelled figure and the drawing it would come from: one stroke for every visible arc, "s0", "s1", …
struct FigureFixture {
  silhouette::LabelledFigure figure;
  Drawing drawing;
};

/// A closed polyline with the surface on its left (+1) or right (-1).
struct FixtureContour {
  std::vector<Vec2> points;
  int side = 1;
  Index object = 0;
};

/// Surfaces in front of a contour at a place: the index of a contour's point plus a fraction of the segment after it.
using DepthAt = std::function<int(Index contour, double position)>;

/// Cuts the contours at their crossings and labels, triangulates and counts layers. Contours must cross transversally.
/// @param step spacing of the contours' points
FigureFixture figure_of_contours(const std::vector<FixtureContour>& contours,
                                 const std::vector<std::string>& object_names, double step, const DepthAt& depth_at);

/// One outline that nothing covers, of an object without holes.
FigureFixture figure_of_outline(const std::string& name, const std::vector<Vec2>& outline, double step);

FigureFixture disk_figure();              ///< radius 100
FigureFixture ring_figure();              ///< an annulus, radii 80 and 120
FigureFixture capsule_figure();           ///< 300 long, radius 40
FigureFixture crossed_capsules_figure();  ///< two capsules like a plus sign, the first one in front
FigureFixture figure_eight_figure();      ///< a closed tube that crosses itself once: an immersed annulus
FigureFixture snake_figure();             ///< an open tube that makes a loop across itself
FigureFixture trefoil_figure();           ///< a tube tied into a trefoil knot
FigureFixture linked_rings_figure();      ///< two rings, each in front of the other at one place

/// All of the above, named after themselves.
struct NamedFigure {
  std::string name;
  FigureFixture fixture;
};
std::vector<NamedFigure> all_figures();

silhouette::Skeleton skeleton_of(const silhouette::LabelledFigure& figure, double node_spacing = 0.3);

/// The sheets of a figure with the usual settings.
silhouette::InflatedSheets inflated_sheets(const silhouette::LabelledFigure& figure);

}  // namespace croquis::test
