// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/bicubic_spline.h"
#include "croquis/geometry/brep.h"

/// Gregory patches as B-spline surfaces, which is what other programs read. Gregory patches are rational of degree 7
/// with weights that vanish at the corners, which no format of B-splines takes.
namespace croquis {

struct BicubicFitOptions {
  double tolerance = 1e-4;                       ///< greatest distance, × diagonal of the box of the solid; > 0
  double angle = 0.05 * std::numbers::pi / 180;  ///< radians, greatest turn of the normals along smooth sides; > 0
  std::size_t most_spans = 40;                   ///< in each direction, 1..200
};

/// A fit with what was measured at places between those that it was made from.
struct BicubicFit {
  BicubicSpline spline;
  double error = 0;    ///< model units: greatest distance of places that have the same parameters
  double angle = 0;    ///< radians: greatest angle between the normals along smooth sides, where both have one
  bool within = true;  ///< both bounds are kept
};

/// The B-spline surface near a patch, with the patch's parameters: (0,0) is corner 0, (1,0) corner 1.
///
/// The four sides are the patch's own curves, and the slopes across them are the patch's too, but for the knot spans
/// next to the corners: there the two twists of a Gregory patch become their mean. What is inside is fitted by least
/// squares. Knots are added, halving the spans with the greatest errors, until both bounds are kept or no more spans
/// are allowed.
/// @param tolerance model units; the options' own isn't used
/// @param smooth which sides continue smoothly into another patch or plane
BicubicFit fit_bicubic(const GregoryPatch& patch, double tolerance, const std::array<bool, 4>& smooth,
                       const BicubicFitOptions& options = {});

/// Fits of all patches: per face, in the order of its patches. Sides of neighbours that are the same cubic stay the
/// same curve, whatever their knots.
/// @throws Cancelled
std::vector<std::vector<BicubicFit>> fit_patches(const Brep& brep, Progress& progress,
                                                 const BicubicFitOptions& options = {});

}  // namespace croquis
