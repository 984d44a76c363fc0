// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "support/sketches/sketch.h"

/// Ready sketches, about 900 by 700 units, y up. Strokes / crossings of each are asserted in sketch_test.cpp.
namespace croquis::test {

Sketch circle_sketch();                           ///< 1 closed stroke
Sketch annulus_sketch();                          ///< two nested circles: a flat ring
Sketch trefoil_sketch();                          ///< torus tied into a (2,3) knot
Sketch torus_knot_sketch(int turns, int petals);  ///< (2,3), (2,5), (3,4): turns round the centre, petals outside
Sketch snake_sketch();                            ///< an open tube lying across itself once
Sketch figure_eight_sketch();                     ///< a closed tube crossing itself once
Sketch ring_and_bar_sketch();                     ///< a bar threaded through a ring
Sketch linked_rings_sketch();                     ///< two rings, each through the other
Sketch borromean_sketch();                        ///< three rings, no two of them linked
Sketch chain_sketch(int rings = 5);
Sketch weave_sketch(int columns = 4, int rows = 4);  ///< bars, alternately over and under
Sketch three_blobs_sketch();                         ///< overlapping pairwise
Sketch dog_sketch();                                 ///< body, head, ear, tail, two legs before the body and two behind
Sketch duck_sketch();                                ///< body, head, beak, wing, tail, two feet
Sketch octopus_sketch();                             ///< a head over eight arms, two of them crossing each other
Sketch bear_sketch();                                ///< head, body, ears and legs behind them, arms before
Sketch fish_sketch();                                ///< body, a fin before it, tail and two fins behind
Sketch mushroom_sketch();                            ///< one large, one small, and a slug before the stem

/// Smooth blobs and capsules in random order, each overlapping another; never one wholly inside another.
/// @param parts 2..12
Sketch random_layered_sketch(std::uint64_t seed, int parts);

/// One closed tube along a random smooth curve, passing over or under itself at random.
Sketch random_tube_sketch(std::uint64_t seed);

/// Everything above that takes no seed, with its name.
struct NamedSketch {
  std::string name;
  Sketch sketch;
};
std::vector<NamedSketch> all_sketches();

/// all_sketches(), and `count` each of random layers and random tubes, seeds from 0.
std::vector<NamedSketch> sketches_with_random_ones(std::uint64_t count);

}  // namespace croquis::test
