// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "algorithms/silhouette/surface/shell.h"

namespace croquis::silhouette {

/// Rounds the seams between joined parts: a band along each seam is triangulated anew, evenly, and then bent as little
/// as it can be (least squares of the Laplacian over the band; Kobbelt et al. 1998) while what lies around it stays.
/// Outlines stay lines of edges, and bend with the band: they are moved where they meet the other part, and only there.
/// @param radii  per pair of objects the half width of the band, sketch units; other seams stay sharp
/// @param finest length of the bands' edges at least, sketch units
/// @return none where there is nothing to round or the band can't be triangulated; what is returned must be checked for
///         intersections
/// O(n log n) in the vertices of the bands, O(n) in the others.
std::optional<Shell> blend_seams(const Shell& joined, const std::map<ObjectPair, double>& radii, double finest);

}  // namespace croquis::silhouette
