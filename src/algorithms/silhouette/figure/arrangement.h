// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A closed contour before it is crossed with the others.
struct ContourPath {
  /// How much of a segment is drawn; a stem's last segment is drawn up to its bar.
  enum class Drawn : std::uint8_t { No, Yes, UntilCut, FromCut };

  Points points;
  std::vector<Drawn> drawn;    ///< per segment i → i+1, cyclic
  std::vector<double> cut;     ///< per segment: fraction at which its bar crosses it
  std::vector<Index> stroke;   ///< per segment: the stroke drawn, or of a completion the stroke it continues
  std::vector<Index> line;     ///< per segment: the drawn line, no_index for a completion
  std::vector<Index> strokes;  ///< in order along the contour
  int side = 0;                ///< surface left (+1), right (-1), unknown (0)
};

/// A crossing of contours a and b, or of a with itself.
struct ContourCrossing {
  enum class Over : std::uint8_t { Unknown, A, B };

  Index vertex = 0;
  Index contour_a = 0;
  Index position_a = 0;  ///< of the vertex in contour a
  Index contour_b = 0;
  Index position_b = 0;
  int sign = 0;               ///< of cross(direction of a, direction of b)
  Over over = Over::Unknown;  ///< known at a T-junction: the bar
};

/// A contour with its crossings as vertices.
struct CrossedContour {
  std::vector<Index> vertices;      ///< cyclic
  std::vector<std::uint8_t> drawn;  ///< per segment
  std::vector<Index> stroke;        ///< per segment
  std::vector<Index> line;          ///< per segment
};

/// All contours of a part in the plane: crossings are vertices, pieces between them arcs.
struct Arrangement {
  Points points;
  std::vector<CrossedContour> contours;
  std::vector<ContourCrossing> crossings;
  std::vector<FigureArc> arcs;                 ///< by contour, in order along it; depth not yet known
  std::vector<std::array<Index, 2>> segments;  ///< by contour, in order along it
  std::vector<Index> segment_arc;
  std::vector<std::uint8_t> may_be_covered;  ///< per arc: drawn, but something drawn may lie in front of it
};

/// Crosses closed contours with one another: exact predicates, a uniform grid, near O(n).
/// @param order what is known of drawn lines that cross
/// @param spacing usual length of a segment
/// @param merging samples nearer to a crossing than this share of their segment give way to it
Arrangement cross_contours(const std::vector<ContourPath>& contours, const VisibleCrossings& order, double spacing,
                           double merging);

/// The index of the arc that arrives at, or leaves from, a vertex of a contour which is a crossing.
struct ArcEnds {
  std::vector<std::vector<Index>> arc_of_segment;  ///< per contour and segment

  Index before(Index contour, Index position) const {
    const std::vector<Index>& arcs = arc_of_segment[contour];
    return arcs[(position + arcs.size() - 1) % arcs.size()];
  }
  Index after(Index contour, Index position) const { return arc_of_segment[contour][position]; }
};

ArcEnds arc_ends(const Arrangement& arrangement);

}  // namespace croquis::silhouette
