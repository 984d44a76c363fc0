// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "support/sketches/sketch_gallery.h"

/// How hands miss what they mean. Every amount is a share of the size of the object that a stroke belongs to (the
/// diagonal of its outline's bounding box), so that small things are drawn as badly as large ones.
namespace croquis::test {

struct HandOptions {
  double jitter = 0;        ///< standard deviation of a smooth displacement
  double wavelength = 0.2;  ///< shortest of that displacement
  double end_miss = 0;      ///< the most by which an end stops short of its bar or runs past it
  double closing = 0;       ///< of the stroke's own length: most gap or overlap where a closed stroke's ends meet
  double aside = 0;         ///< of its own length: the most by which those ends miss each other sideways
  int pieces = 1;           ///< open strokes are cut into up to so many, closed ones too
  double piece_gap = 0;     ///< the most by which pieces stop short of each other or run past each other
  bool turned = false;      ///< the whole drawing by a random angle
  double retrace = 0;       ///< of a line's length: how far back at most a piece begins over the one before, unsteadily
};

/// The sketch as somebody draws it who means the same. Closed strokes are given open when `closing` or `aside` are
/// not 0. The truth stays that of the sketch, but for its number of strokes.
Drawing drawn_by_hand(const Sketch& sketch, std::uint64_t seed, const HandOptions& options);

/// A named way of drawing badly.
struct HandVariation {
  std::string name;
  HandOptions options;
};
std::vector<HandVariation> hand_variations();

/// What the random variations are measured on: the gallery's animals, knots and links, and a few characters.
std::vector<NamedSketch> hand_sketches();

}  // namespace croquis::test
