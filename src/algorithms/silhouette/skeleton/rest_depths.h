// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Objects cut into those that lie over one another all round: strongly connected components of "lies over".
struct OverlapCycles {
  std::vector<Index> cycle;  ///< per object; what lies below a cycle, and isn't in it, has a smaller number
  Index count = 0;
};

/// @param below per object those that it lies over; itself and repetitions don't matter
/// Tarjan 1972. Linear.
OverlapCycles overlap_cycles(const std::vector<std::vector<Index>>& below);

/// How far the upper one of two different objects lies before the lower one where both are flat, sketch units.
struct ObjectBound {
  double least = 0;
  double reach = 0;  ///< of joined ones: farther apart they don't meet

  ObjectBound() = default;
  ObjectBound(double least_distance, double farthest = 0) : least(least_distance), reach(farthest) {}

  void widen(const ObjectBound& other) {
    least = std::max(least, other.least);
    reach = std::max(reach, other.reach);
  }
};

/// By (upper, lower).
using ObjectBounds = std::map<std::pair<Index, Index>, ObjectBound>;

/// The largest bound of the rows between each two objects.
ObjectBounds object_bounds(const Skeleton& skeleton, std::span<const CollisionRow> rows);

/// Per object the height at which it would rest if it were flat and rigid: no nearer to what it lies over than the
/// bounds say, the objects that lie over one another as near to the same height as that allows, and like parts of one
/// body (legs, petals) equally far before or behind it, joined ones as far as they reach.
///
/// Objects that lie over one another all round, as links do, share one height: none of them can be flat.
/// A larger object stays nearer to the sketch plane, and so does one with a larger weight of distance. The heights
/// don't depend on the order of objects or on where and how large the drawing is.
/// @return sketch units
/// @throws Cancelled
std::vector<double> rest_depths(const Skeleton& skeleton, const ObjectBounds& bounds, const DepthSettings& settings,
                                Progress& progress);

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
