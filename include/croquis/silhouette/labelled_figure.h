// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/stroke_data.h"

/// From strokes to a labelled figure: every contour closed, every piece of it with the number of surfaces in front.
/// Cordier, Seo, Cho 2006, section 3; Williams 1994 (figural completion and labelling).
namespace croquis::silhouette {

/// A closed contour of a smooth solid: drawn strokes joined by completed hidden pieces.
struct FigureContour {
  std::vector<Index> vertices;      ///< cyclic, indices into LabelledFigure::points; segment i joins i and i+1
  std::vector<std::uint8_t> drawn;  ///< per segment: 1 = stroke, 0 = completion or bridge over a joined gap's far side
  std::vector<Index> strokes;       ///< indices into Drawing::strokes, in the order along the contour
  int side = 1;                     ///< sigma: the surface lies on the left (+1) or the right (-1)
  Index object = 0;                 ///< index into LabelledFigure::objects
};

/// A piece of contour between two crossings (a contour without crossings is one arc).
struct FigureArc {
  Index contour = 0;
  Index begin = 0;      ///< position of its first segment in the contour
  Index count = 0;      ///< number of segments, cyclic
  bool visible = true;  ///< most of its length is drawn
  int depth = 0;        ///< n: surfaces in front of it; 0 exactly for visible arcs
};

/// Two contours (or one with itself) cross here.
struct FigureCrossing {
  Index vertex = 0;
  Index over_contour = 0;
  Index over_position = 0;  ///< index of the crossing vertex in the over contour's vertices
  Index under_contour = 0;
  Index under_position = 0;
  bool seen = true;  ///< what is drawn shows which one is over; else it is the cheapest labelling
};

/// Two tubes that were drawn as centre lines, or one with itself, pass over one another here.
struct TubeCrossing {
  Index stroke = 0;  ///< the later one of both: index into Drawing::strokes
  Index other = 0;   ///< the same stroke where it crosses itself
  Index word = 0;    ///< which of the stroke's crossings this is, see `over_key`
  bool over = true;  ///< the stroke lies in front, where it first comes here
  Vec2 at = Vec2::Zero();
};

/// A hidden contour piece that joins two stroke ends.
struct FigureCompletion {
  std::vector<Vec2> points;  ///< from the one end to the other, both included
  Index contour = 0;
  double cost = 0;  ///< dimensionless
  EndPair ends{};   ///< that it joins
};

/// One solid of the drawing: a connected component of the paneling (or all that a group was forced into).
struct FigureObject {
  std::string name;            ///< the group's data-object, else the id of its first stroke
  std::vector<Index> strokes;  ///< indices into Drawing::strokes
  std::vector<Index> contours;
  int euler_region = 0;  ///< Euler number of its immersed region, from the turning numbers of its contours
  bool tube = false;     ///< limbs that were drawn as one line
};

/// One place where an object passes in front of another, or of itself: the region of a pair of layers.
struct FigureOverlap {
  Vec2 at = Vec2::Zero();  ///< inside the region
  Index upper = 0;         ///< objects
  Index lower = 0;
  /// Corners of the region, indices into LabelledFigure::crossings, ascending: four where a tube crosses a tube, two
  /// where one's end lies over or under the other, none where the upper one lies wholly before the lower one.
  std::vector<Index> crossings;
  bool whole_outlines = false;     ///< both are closed outlines that cross in full view
  Index tube_crossing = no_index;  ///< index into LabelledDrawing::tube_crossings, for strands of tubes
};

/// A closed outline drawn within another one's surface, and how it is read.
struct NestedOutline {
  Index stroke = 0;        ///< indices into Drawing::strokes
  Index around = 0;        ///< one that bounds the surface around it
  bool hole = false;       ///< else it bounds a part in front
  bool chosen = false;     ///< by the stroke's "kind", see stroke_data.h; else by its shape
  Vec2 at = Vec2::Zero();  ///< on the outline, sketch units
};

/// The labelled figure of one part of a drawing; parts share no contour, crossing or overlap.
struct LabelledFigure {
  double unit = 1;           ///< u of the whole drawing
  double step = 6;           ///< spacing of the samples, sketch units (not u)
  std::vector<Vec2> points;  ///< contour samples and crossings, y up
  std::vector<FigureContour> contours;
  std::vector<FigureArc> arcs;
  std::vector<FigureCrossing> crossings;
  std::vector<FigureCompletion> completions;
  std::vector<FigureObject> objects;
  std::vector<FigureOverlap> overlaps;
  std::vector<NestedOutline> nested;  ///< closed strokes whose side no junction shows
  /// #S by 2: contour by contour every segment once, by its position; the constraints of the triangulation.
  std::vector<std::array<Index, 2>> segments;
  std::vector<Index> segment_arc;     ///< #S: the arc that a segment belongs to
  PlanarTriangulation triangulation;  ///< of points, constrained to segments
  std::vector<int> layers;            ///< per triangle: w, the number of surfaces there
  std::vector<Index> faces;           ///< per triangle: the face of the arrangement it lies in (0 = outside)
  std::vector<std::vector<Vec2>>
      raw_contours;  ///< per contour the strokes before smoothing, completions between: for checks
  int panels = 0;    ///< sum of w over the faces
};

/// The samples of a contour, crossings included.
inline std::vector<Vec2> contour_points(const LabelledFigure& figure, Index contour) {
  std::vector<Vec2> points;
  for (const Index v : figure.contours[contour].vertices) points.push_back(figure.points[v]);
  return points;
}

/// Two outlines that cross in full view, and which of them is read as the one in front.
struct CrossingInView {
  Index front = 0;  ///< indices into Drawing::strokes
  Index behind = 0;
  Vec2 at = Vec2::Zero();  ///< one of the places where they cross, sketch units
  bool chosen = false;     ///< by the stroke's "behind", see stroke_data.h; else by the order of drawing
  bool whole = false;      ///< both are closed outlines; else one ends within the other
};

struct LabelledDrawing {
  std::vector<LabelledFigure> figures;  ///< independent parts that could be labelled
  std::vector<StrokeKind> kinds;        ///< per stroke of the drawing, none of them Visible
  std::vector<CrossingInView> crossings;
  std::vector<TubeCrossing> tube_crossings;
  std::vector<EndPair> joined;  ///< ends that are one place of a line in full view
  double cost = 0;              ///< of all that is supposed: kinds, connections, hidden pieces; dimensionless
  Findings findings;            ///< warnings, and the errors of parts that could not
};

/// Sections 4 to 7: prepares strokes, finds which ends pass behind what, completes and labels the contours.
///
/// One bad part doesn't stop the others; all findings of the drawing come at once.
/// @throws Error carrying all findings when no part can be labelled; Cancelled
LabelledDrawing label(const Drawing& drawing, const Options& options, Progress& progress);

/// The drawing with what lies over what turned round where tubes cross: the "over" of strokes is written.
/// @param overlaps those of all figures counted through, in their order
/// @throws Error (E_SWAP) naming the first one that isn't of strands of tubes
Drawing swap_overlaps(Drawing drawing, const LabelledDrawing& labelled, const std::vector<Index>& overlaps);

}  // namespace croquis::silhouette
