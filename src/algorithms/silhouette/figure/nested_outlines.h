// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/arrangement_faces.h"
#include "algorithms/silhouette/figure/contour_paths.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A closed contour within another one's surface that no junction says the side of.
struct NestedContour {
  Index contour = 0;
  Index around = 0;  ///< the smallest contour that it lies in
  bool hole = false;
  bool chosen = false;
};

/// What the drawing leaves open: whether a closed outline within another bounds a hole or a part in front.
///
/// A stroke's own "kind" decides, then its object: outlines of different named objects are no holes of each other. Else
/// it is judged by its shape. Holes are what rings of even width go round, along most of the outline; the thicker the
/// ring for its hole, the more does whatever lies over it, or beside the hole in the same outline, speak for a part: a
/// belly or an eye on a body rather than a ring.
/// O(#nested * samples of the two contours).
std::vector<NestedContour> nested_contours(const Drawing& drawing, const std::vector<ContourPath>& paths,
                                           const Arrangement& arrangement, const Faces& faces);

/// Where the surface lies along each contour, after that reading: left (+1), right (-1), open (0).
std::vector<int> sides_with(const std::vector<NestedContour>& nested, const std::vector<ContourPath>& paths);

/// The strokes of the contours, for what is told of them.
std::vector<NestedOutline> nested_outlines(const std::vector<NestedContour>& nested,
                                           const std::vector<ContourPath>& paths);

/// One note (W_NESTED) for every outline that was read by its shape.
Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure);

}  // namespace croquis::silhouette
