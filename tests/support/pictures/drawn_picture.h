// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/geometry/vector.h"

/// Pictures of drawings as scanners, phones and drawing programs make them.
namespace croquis::test {

struct InkLine {
  std::vector<Vec2> points;  ///< of the sheet, whose longer side is 1000; y points down
  bool closed = false;
  bool filled = false;  ///< a closed one's inside too
};

struct PictureLook {
  int width = 1000;          ///< pixels
  int height = 750;          ///< pixels
  double line_width = 5;     ///< units of the sheet
  double paper = 0.9;        ///< brightness, 0..1
  double ink = 0.15;         ///< the same
  double fading = 0;         ///< part of the light that is lost from the left to the right
  double shadow = 0;         ///< part of the light that is lost below a diagonal
  double shadow_edge = 0;    ///< units over which that shadow begins
  double desk = 0;           ///< units around the sheet that are dark, seen at a slant
  double squares = 0;        ///< part of the light that is lost at lines of squared paper, 40 units apart
  double noise = 0;          ///< standard deviation of the brightness
  bool transparent = false;  ///< ink on nothing
};

/// RGBA with 8 bits, top row first: each pixel is covered as far as lines reach into it.
std::vector<std::uint8_t> drawn_pixels(const std::vector<InkLine>& lines, const PictureLook& look);

InkLine ink_line(std::vector<Vec2> points, bool closed = false);

/// Points on a circle.
InkLine ink_circle(const Vec2& centre, double radius, bool filled = false);

}  // namespace croquis::test
