// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"

/// What the lines of a drawing enclose, gaps and all: regions first, before any end is understood.
namespace croquis::silhouette {

/// The outline of one connected region.
struct EnclosedRegion {
  Points outline;              ///< closed, counter-clockwise, along strokes and across gaps
  std::vector<Index> stroke;   ///< per point: position of the stroke it lies on
  std::vector<double> shared;  ///< per stroke: length of it on the outline
  std::vector<double> left;    ///< per stroke: length along which the region lies on its left, minus that on its right
  double area = 0;
};

struct Envelope {
  std::vector<EnclosedRegion> regions;  ///< largest first; specks are left out
  std::vector<double> seen;             ///< per stroke: share of all outlines' length that it makes
  std::vector<double> outside;          ///< per stroke: share of it that lies outside everything
  double diagonal = 0;                  ///< of the drawing
};

/// Divides the plane into inside and outside by one minimum cut through the Delaunay triangulation of all lines'
/// samples. A triangle is rather inside the more lines are met in all directions from its middle, and rather outside
/// else; an edge between the two costs its length where no line covers it and next to nothing where one does. Gaps are
/// closed where that is cheap for what they enclose, however many lines run through it.
/// Boykov and Kolmogorov 2004. O(n log n) and the cut, some milliseconds for a usual drawing.
Envelope enclosed_regions(const std::vector<SampledStroke>& strokes);

}  // namespace croquis::silhouette
