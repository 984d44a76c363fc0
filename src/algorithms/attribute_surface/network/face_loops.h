// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"

namespace croquis {

/// How many curves a loop may have; above most_tame there is a warning.
inline constexpr std::size_t most_sides = 64;
inline constexpr std::size_t most_tame_sides = 12;

/// By face: whether its loop closes. Errors name what fails: E_TOO_FEW, E_TOO_MANY, E_OPEN_LOOP; W_TOO_MANY. A face
/// of a curve that failed fails without a finding of its own.
std::vector<bool> closed_loops(const AttributeNetwork& network, const LoopCurves& curves, double tolerance,
                               Findings& findings);

/// The faces with a closed loop around each curve.
std::vector<std::vector<Index>> faces_of_curves(const AttributeNetwork& network, const std::vector<bool>& closed);

/// The number of the corner where a side begins.
std::size_t corner_before(const LoopCurves& curves, const AttributeSide& side);
std::size_t corner_after(const LoopCurves& curves, const AttributeSide& side);

/// By face: whether it is to be turned round so that faces run through common curves in opposite directions. The first
/// face of each part that hangs together stays. Where that can't be: W_ORIENT, and one of them stays wrong.
std::vector<bool> flipped_faces(const AttributeNetwork& network, const std::vector<std::vector<Index>>& faces_of_curve,
                                Findings& findings);

/// Whether a face's loop runs through a curve backwards.
/// @pre it has the curve
bool runs_backwards(const AttributeFace& face, Index curve);

}  // namespace croquis
