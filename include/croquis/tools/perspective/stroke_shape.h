// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"

/// What the pen meant: lines and smooth curves.
namespace croquis {

/// A line, or a chain of cubics that join smoothly.
struct StrokeShape {
  std::vector<PictureCubic> pieces;  ///< at least one
  bool straight = false;             ///< one piece, a line

  const Vec2& start() const { return pieces.front()[0]; }
  const Vec2& end() const { return pieces.back()[3]; }
};

/// The cubic that is a line at constant speed.
PictureCubic line_piece(const Vec2& from, const Vec2& to);

Vec2 place_on(const PictureCubic& piece, double t);

/// Places along a stroke, its ends too. @param per_piece parts of each curved piece, > 0; a line has one part
std::vector<Vec2> traced(const std::vector<PictureCubic>& pieces, bool straight, int per_piece = 24);

enum class Straightness {
  Guess,      ///< a line when it hardly bends
  Always,     ///< a line
  WhenExact,  ///< a line only when a hand wouldn't draw it straighter
};

struct ShapeOptions {
  double units_per_pixel = 1;  ///< of the view drawn in, > 0
  Straightness straightness = Straightness::Guess;
};

/// The shapes that a gesture was meant as: one, or at corners one for each side; four of a loop without corners, whose
/// ends meet. Ends of neighbours are the same place. Empty for a gesture that is no longer than a few pixels.
/// @param places #P by 2, px, finite
std::vector<StrokeShape> shapes_of(std::span<const Vec2> places, const ShapeOptions& options = {});

/// The shape with its ends at other places. Lines stay lines; of a curve the handles at the ends move along.
StrokeShape with_ends(StrokeShape shape, const Vec2& start, const Vec2& end);

}  // namespace croquis
