// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "support/sketches/sketch.h"

/// Sketches of bodies with limbs that grow out of them.
namespace croquis::test {

/// A body, a head over its edge, a tail behind it, and two to six limbs, each from before or from behind the body;
/// sizes, places and bends by chance. Limbs may lie over one another.
Sketch random_figure_sketch(std::uint64_t seed);

/// A capsule from inside a disk to beyond its rim, before the disk or behind it.
Sketch limb_on_blob_sketch(bool limb_in_front);

}  // namespace croquis::test
