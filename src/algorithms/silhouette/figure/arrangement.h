// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/stroke_data.h"

/// Contours are closed by the hidden pieces that are chosen, crossed with one another, and bound faces.
namespace croquis::silhouette {

/// What every part of a drawing is searched in.
struct FigureContext {
  const Drawing& drawing;
  const Options& options;
  const DrawingScale& scale;
  const std::vector<CleanLine>& lines;  ///< carried on behind their bars
  const Junctions& junctions;
  const VisibleCrossings& order;
  std::vector<PinnedEnds> pins{};
};

/// The end of a stroke that the end of a line is.
StrokeEnd stroke_end(const FigureContext& context, const HiddenEnd& end);

/// The lines, ends and candidates of one part of a drawing.
struct PartLines {
  std::vector<Index> lines;                     ///< ascending
  std::vector<Index> ends;                      ///< indices into Junctions::ends: by open line its start and its end
  std::vector<CompletionCandidate> candidates;  ///< between positions in `ends`
};

/// A completion that is taken.
struct ChosenCompletion {
  Index candidate = 0;
  Index shape = 0;  ///< position in the candidate's shapes
};

/// What a segment of a contour is a piece of.
struct ContourSegment {
  bool drawn_before = false;    ///< the cut
  bool drawn_after = false;     ///< the same but of a stem's last segment, which is drawn up to its bar
  Index stroke = 0;             ///< the stroke drawn, or of a completion the stroke it continues
  Index line = no_index;        ///< the drawn line, no_index for a completion
  Index completion = no_index;  ///< which of the chosen completions, no_index for a line
  double cut = 0;               ///< fraction at which its bar crosses it
  TubePlace tube{};             ///< of the outline of one that has a centre line
};

/// A closed contour before it is crossed with the others.
struct ContourPath {
  Points points;
  std::vector<ContourSegment> segments;  ///< i → i+1, cyclic
  Points raw;                            ///< per point: where it was before it was smoothed
  std::vector<Index> strokes;            ///< in order along the contour
  int side = 0;                          ///< surface left (+1), right (-1), unknown (0)
};

/// A crossing of two contours, or of one with itself.
struct ContourCrossing {
  /// One of the two that cross here.
  struct Strand {
    Index contour = 0;
    Index position = 0;  ///< of the crossing among the contour's vertices
    Index before = 0;    ///< the arcs that arrive here and leave
    Index after = 0;
  };

  std::array<Strand, 2> strands;
  int sign = 0;              ///< of cross(direction of the first, direction of the second)
  Index over = no_index;     ///< the strand in front where that is known: at a T-junction the bar
  Index passing = no_index;  ///< of tubes: index into VisibleCrossings::passings
};

/// All contours of a part in the plane, before they are labelled: crossings are vertices, the first of the points;
/// pieces between them are arcs. Sides are 0 where they are unknown. Filled by the three steps below, in their order.
struct Arrangement : LabelledFigure {
  std::vector<ContourPath> paths;  ///< that the contours are made of, by the lowest line in them
  std::vector<ContourCrossing> contour_crossings;
  std::vector<ContourSegment> origins;       ///< per segment: what it is a piece of
  std::vector<Index> first_segment;          ///< per contour
  std::vector<std::uint8_t> may_be_covered;  ///< per arc: drawn, but something drawn may lie in front of it

  // The faces are the connected pieces of the plane without the contours; face 0 is outside all.
  std::vector<double> area;                      ///< per face; 0 of face 0
  std::vector<std::vector<int>> winding;         ///< per face and contour: times the contour goes round it
  std::vector<std::array<Index, 2>> beside_arc;  ///< per arc: the faces on its left and right
  std::vector<Vec2> conflicts;  ///< places where contours overlap or meet in one point; then there are no faces

  /// The k-th segment of an arc.
  Index segment_of(const FigureArc& arc, Index k) const {
    const Index count = static_cast<Index>(contours[arc.contour].vertices.size());
    return first_segment[arc.contour] + (arc.begin + k) % count;
  }
};

/// Joins lines and completions to closed contours, which aren't crossed yet. None when they would put the surface on
/// both sides of a contour.
/// @param chosen  every end in exactly one
Arrangement close_contours(const FigureContext& context, const PartLines& part,
                           const std::vector<ChosenCompletion>& chosen);

/// Crosses closed contours with one another: exact predicates, a uniform grid, near O(n).
/// @param order what is known of drawn lines that cross
/// @param spacing usual length of a segment
/// @param merging samples nearer to a crossing than this share of their segment give way to it
Arrangement cross_contours(Arrangement closed, const VisibleCrossings& order, double spacing, double merging);

/// Triangulates the arrangement and floods it from outside, so that nested contours need no special care.
void find_faces(Arrangement& arrangement);

}  // namespace croquis::silhouette
