// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"

/// Sketches made from known solids: what is drawn, together with everything a silhouette algorithm should find out.
namespace croquis::test {

/// A closed contour of the solid, hidden pieces included.
struct TrueContour {
  std::vector<Vec2> points;    ///< closed (the first is not repeated), the surface on the left
  std::vector<double> height;  ///< per point: of two contours that cross, the higher one is in front
  int component = 0;           ///< the object it bounds
};

struct TrueCrossing {
  Vec2 at = Vec2::Zero();
  int over = 0;     ///< contour in front
  int under = 0;    ///< contour behind
  double sine = 1;  ///< of the angle between the two, 0..1
};

/// Counts that follow from the solid alone, whatever the stroke order, direction, scale or view rotation.
struct SketchTruth {
  int strokes = 0;  ///< visible pieces
  int contours = 0;
  int crossings = 0;  ///< X, of contours with each other and with themselves
  int arcs = 0;       ///< 2X + contours without a crossing
  int hidden_arcs = 0;
  std::vector<int> depth_histogram;  ///< arcs by number of surfaces in front
  int panels = 0;                    ///< sum over faces of the number of layers
  int components = 0;
  std::vector<int> euler_region;  ///< per component: of the flat immersed region M
  std::vector<int> euler_mesh;    ///< per component: of the closed solid, twice that of M
  std::vector<TrueContour> outlines;
  std::vector<TrueCrossing> places;  ///< one per crossing
};

struct Sketch {
  Drawing drawing;
  SketchTruth truth;
};

/// Draws what is visible of contours, cut where one passes behind another: ends lie on the other's polyline exactly.
/// Every contour must have a visible piece.
/// @param euler_region per component
/// @throws std::logic_error when the heights contradict each other (a contour would sink at every turn)
Sketch draw_visible(std::vector<TrueContour> contours, std::vector<int> euler_region);

/// How many layers of surface lie over a place of the sketch plane; 0 is outside the silhouette.
/// Linear in the number of contour points.
int layers_at(const SketchTruth& truth, const Vec2& place);

/// Times that a closed polyline goes round a place, counterclockwise positive.
int winding(const std::vector<Vec2>& loop, const Vec2& place);

/// A stroke through the points, with no pen data.
Stroke stroke_of(const std::string& id, const std::vector<Vec2>& points, bool closed = false);

}  // namespace croquis::test
