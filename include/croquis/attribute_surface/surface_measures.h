// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"

/// How well a surface keeps to what it is made from.
namespace croquis {

class StageCache;

struct PatchMeasures {
  Index face = no_index;
  std::vector<double> side_lengths;  ///< model units, of the curves; of a face of two sides four halves
  double beta = 0;
  double radius = 0;
  bool centre_inside = true;
  double sigma = 0;
  double anisotropy = 1;  ///< >= 1: of the greatest stretch of the map over the least, geometric mean over the domain
  double folded = 0;      ///< 0..1, share of places whose normal points away from the loop's
};

struct SurfaceMeasures {
  std::vector<PatchMeasures> patches;               ///< of the faces that could be evaluated
  double boundary_error = 0;                        ///< model units: surfaces at their sides against the curves
  std::vector<std::optional<double>> point_errors;  ///< by point, model units
  /// By face and inner curve, model units: the largest distance of a place of the curve to its footprint's. It is 0 at
  /// the samples that the footprint is made of; between them it falls with their distance. None for those left out.
  std::vector<std::vector<std::optional<double>>> inner_errors;
  /// By curve that is smooth, radians: the largest angle of both faces' normals at five places, 2e-6 of the domains'
  /// perimeters inside.
  std::vector<std::optional<double>> normal_jumps;
  double largest_normal_jump = 0;  ///< radians, over smooth curves
};

/// @param cache measures of faces from earlier runs, not owned; null: all are made again
SurfaceMeasures measure(const AttributeNetwork& network, const AttributeSurface& surface, StageCache* cache = nullptr);

}  // namespace croquis
