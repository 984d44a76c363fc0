// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "croquis/tools/perspective/sheet_units.h"
#include "support/perspective/solid_drawing.h"
#include "support/random.h"

/// What a hand would do to draw a solid, and what is known of the solid.
namespace croquis::test {

/// Samples along cubics, about two px apart, that waver and begin and end beside the mark.
/// @param miss px, how far both ends lie from where they should
std::vector<Vec2> hand_drawn(const std::vector<PictureCubic>& pieces, Random& random, double miss);

/// The truth, as the studio would know it. @param open strokes that lack a face
SolvedDrawing truth_of(const SolidDrawing& drawn, std::vector<std::string> open = {});

/// The solid drawn exactly, without vertex names or what is known.
SolidDrawing plain_drawing(const PerspectiveSolid& solid, const View& view);

}  // namespace croquis::test
