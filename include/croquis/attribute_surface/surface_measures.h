// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"

/// How well a surface keeps to what it is made from.
namespace croquis {

struct PatchMeasures {
  Index face = no_index;
  std::vector<double> side_lengths;  ///< model units, of the curves; of a face of two sides four halves
  double beta = 0;
  double radius = 0;
  bool centre_inside = true;
  double sigma = 0;
  double anisotropy = 1;  ///< >= 1: mean of the ratio of the greatest stretch of the map to the least
  double folded = 0;      ///< 0..1, share of places whose normal points away from the loop's
};

struct SurfaceMeasures {
  std::vector<PatchMeasures> patches;               ///< of the faces that could be evaluated
  double boundary_error = 0;                        ///< model units: surfaces at their sides against the curves
  std::vector<std::optional<double>> point_errors;  ///< by point, model units
  std::vector<std::vector<double>> inner_errors;    ///< by face and inner curve, model units
  std::vector<std::optional<double>> normal_jumps;  ///< by curve that is smooth: radians, the largest
  double largest_normal_jump = 0;                   ///< radians, over smooth curves
};

SurfaceMeasures measure(const AttributeNetwork& network, const AttributeSurface& surface);

}  // namespace croquis
