// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/silhouette/surface/inflation.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

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
FigureFixture figure_of_contours(std::span<const FixtureContour> contours, std::span<const std::string> object_names,
                                 double step, const DepthAt& depth_at);

/// A round tube; its centre line bends less than its radius allows and rises and falls gently.
struct FixtureTube {
  std::string name;
  std::vector<Vec3> centre;  ///< densely sampled; one point for a ball
  double radius = 1;
  bool closed = false;
};

/// @param step spacing of the contours' points; 0: 6/1000 of the figure's diagonal
FigureFixture figure_of_tubes(std::span<const FixtureTube> tubes, double step = 0);

FigureFixture disk_figure();              ///< radius 100
FigureFixture ring_figure();              ///< an annulus, radii 80 and 120
FigureFixture capsule_figure();           ///< 300 long, radius 40
FigureFixture crossed_capsules_figure();  ///< two capsules like a plus sign, the first one in front
FigureFixture figure_eight_figure();      ///< a closed tube that crosses itself once: an immersed annulus
FigureFixture snake_figure();             ///< an open tube that makes a loop across itself
FigureFixture trefoil_figure();           ///< a tube tied into a trefoil knot
FigureFixture linked_rings_figure();      ///< two rings, each in front of the other at one place

/// The sheets of a figure with the usual settings.
silhouette::InflatedSheets inflated_sheets(const silhouette::LabelledFigure& figure);

}  // namespace croquis::test
