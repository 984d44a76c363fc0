// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/attribute_surface/surface_tessellation.h"

namespace croquis {

/// The samples of every curve that a loop uses, by curve; none of the others.
std::vector<CurveSamples> sample_curves(const AttributeNetwork& network, const AttributeSurface& surface,
                                        const SurfaceTessellationOptions& options);

/// Fractions of the curve's arc length between which chords keep to it.
/// @param least parts, 1 or more
std::vector<double> fractions_by_chords(const ArcLengthCurve& curve, double tolerance, std::size_t least);

}  // namespace croquis
