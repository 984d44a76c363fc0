// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/silhouette/labelled_figure.h"

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
};

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
};

/// A closed contour before it is crossed with the others.
struct ContourPath {
  Points points;
  std::vector<ContourSegment> segments;  ///< i → i+1, cyclic
  Points raw;                            ///< per point: where it was before it was smoothed
  std::vector<Index> strokes;            ///< in order along the contour
  int side = 0;                          ///< surface left (+1), right (-1), unknown (0)
};

/// Closed contours that a choice of completions makes of the lines; none when they would put the surface on both sides
/// of a contour.
struct ClosedContours {
  std::vector<ContourPath> paths;             ///< by the lowest line in them
  std::vector<FigureCompletion> completions;  ///< one per candidate chosen
};

/// Joins lines and completions.
/// @param chosen  every end in exactly one
ClosedContours close_contours(const FigureContext& context, const PartLines& part,
                              const std::vector<ChosenCompletion>& chosen);

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
  int sign = 0;           ///< of cross(direction of the first, direction of the second)
  Index over = no_index;  ///< the strand in front where that is known: at a T-junction the bar
};

/// All contours of a part in the plane: crossings are vertices, pieces between them arcs.
struct Arrangement {
  Points points;                        ///< the crossings first
  std::vector<FigureContour> contours;  ///< side 0 where it is unknown; objects not yet known
  std::vector<ContourCrossing> crossings;
  std::vector<FigureArc> arcs;                 ///< by contour, in order along it; depth not yet known
  std::vector<std::array<Index, 2>> segments;  ///< by contour, in order along it
  std::vector<ContourSegment> origins;         ///< per segment: what it is a piece of
  std::vector<Index> first_segment;            ///< per contour
  std::vector<Index> segment_arc;
  std::vector<std::uint8_t> may_be_covered;  ///< per arc: drawn, but something drawn may lie in front of it

  /// The k-th segment of an arc.
  Index segment_of(const FigureArc& arc, Index k) const {
    const Index count = static_cast<Index>(contours[arc.contour].vertices.size());
    return first_segment[arc.contour] + (arc.begin + k) % count;
  }
  Index middle_segment(const FigureArc& arc) const { return segment_of(arc, arc.count / 2); }
};

/// Crosses closed contours with one another: exact predicates, a uniform grid, near O(n).
/// @param order what is known of drawn lines that cross
/// @param spacing usual length of a segment
/// @param merging samples nearer to a crossing than this share of their segment give way to it
Arrangement cross_contours(const std::vector<ContourPath>& contours, const VisibleCrossings& order, double spacing,
                           double merging);

/// The faces of an arrangement: connected pieces of the plane without its contours. Face 0 is outside all.
struct Faces {
  PlanarTriangulation triangulation;  ///< of the arrangement's points, constrained to its segments
  std::vector<Index> of_triangle;
  std::vector<double> area;                      ///< per face; 0 of face 0
  std::vector<std::vector<int>> winding;         ///< per face and contour: times the contour goes round it
  std::vector<std::array<Index, 2>> beside_arc;  ///< per arc: the faces on its left and right
  std::vector<Vec2> conflicts;  ///< places where contours overlap or meet in one point; then there are no faces
};

/// Triangulates the arrangement and floods it from outside, so that nested contours need no special care.
Faces find_faces(const Arrangement& arrangement);

}  // namespace croquis::silhouette
