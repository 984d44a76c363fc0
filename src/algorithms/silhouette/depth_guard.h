// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// How deep a figure is that its drawing explains: the widths of objects that lie over one another, each with the gap
/// to the next, summed along the chain of such objects where that is most. An object that passes over itself counts
/// once more for every place where it does; objects that lie over one another in a cycle count all.
/// @param gap least distance between sheets, sketch units
/// @param thickness per object, see DepthSettings; empty: 1
/// @return sketch units; linear in objects and overlaps
double explained_depth(const LabelledFigure& figure, const Skeleton& skeleton, double gap,
                       const std::vector<double>& thickness = {});

/// Where an object lies along z.
struct DepthRange {
  Index object = 0;
  double low = 0;
  double high = 0;
};

/// Objects to leave out so that the others lie, all together, within that depth: as long as they don't, the one that
/// reaches farthest from the sketch plane is left out. Ascending.
std::vector<Index> objects_too_deep(std::vector<DepthRange> ranges, double most);

}  // namespace croquis::silhouette
