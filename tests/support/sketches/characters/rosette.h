// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/sketches/sketch.h"

/// Flowers and octopuses with any number of limbs.
namespace croquis::test {

/// Limbs all round a disc of radius 130 that covers their inner ends, each over the one before: every pair of ends is
/// a choice.
/// @param share of the limbs' width in the room that they have on the disc's rim
/// @param turns of the disc's rim that they take up
/// @param reach of the limbs from the disc's middle
/// @param bend  aside, of limbs that aren't straight
Sketch rosette_sketch(int limbs, double share, double turns, double reach, double bend);

}  // namespace croquis::test
