// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The skeleton of a labelled figure: middles of the chords of its immersed region, insignificant branches absorbed and
/// nodes thinned out. Prasad 1997 (chordal axis transform), as used by Cordier, Seo, Cho 2006, section 4.1.
///
/// A tube without ends becomes one loop, a capsule one path, a disk one node. Each node knows its chord, the panels
/// that the chord passes through (walked in its own sheet, never located in the plane) and its object.
/// @param node_spacing local radii between nodes along a branch, 0.1..1; never nearer than 4 u
/// @throws Error (E_INTERNAL) when the figure's depths contradict each other; Cancelled
Skeleton chordal_axis(const LabelledFigure& figure, double node_spacing, Progress& progress);

}  // namespace croquis::silhouette
