// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "algorithms/silhouette/cage/figure_cage.h"
#include "croquis/silhouette/cage.h"

namespace croquis::silhouette {

/// Adds a figure's cage to that of a drawing.
/// @param number   per object of the figure its value in the channel "object"; negative: it is left out
/// @param mirrored objects with a copy on the far side, and the depths that they are mirrored at
void append_cage(const FigureCage& part, std::span<const std::int32_t> number, const std::map<Index, double>& mirrored,
                 QuadCage& cage);

/// Makes a mesh that is nearly its own image, left to right, exactly so.
/// @return whether it is
bool make_symmetric(PolyMesh& mesh);

}  // namespace croquis::silhouette
