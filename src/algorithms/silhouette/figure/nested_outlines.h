// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// Reads what the drawing leaves open: whether a closed outline within another, whose side no junction tells, bounds a
/// hole or a part in front. Sets the sides of the arrangement's contours.
///
/// A stroke's own "kind" decides, then its object: outlines of different named objects are no holes of each other. Else
/// it is judged by its shape. Holes are what rings of even width go round, along most of the outline; the thicker the
/// ring for its hole, the more does whatever lies over it, or beside the hole in the same outline, speak for a part: a
/// belly or an eye on a body rather than a ring.
/// O(#nested * samples of the two contours).
std::vector<NestedOutline> read_nesting(const Drawing& drawing, const std::vector<ContourPath>& paths,
                                        const Faces& faces, Arrangement& arrangement);

/// Name of the object that the strokes of one outline are forced into, empty for none.
std::string told_object(const Drawing& drawing, const std::vector<Index>& strokes);

/// One note (W_NESTED) for every outline that was read by its shape.
Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure);

}  // namespace croquis::silhouette
