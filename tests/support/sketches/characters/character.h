// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/sketches/sketch.h"

/// Drawings as people make them: characters, toys, tools. Each is a stack of named parts, so that what it means is
/// known.
namespace croquis::test {

/// One part; those that come later in a character's list cover those before them.
struct CharacterPart {
  std::string name;
  std::vector<Vec2> outline;             ///< closed and simple, either direction
  std::vector<std::vector<Vec2>> holes;  ///< closed and simple, inside the outline
};

struct Character {
  std::string name;
  std::vector<CharacterPart> parts;  ///< from back to front
};

/// What is visible of each part: lines stop where they pass behind something. Strokes are named after their parts.
/// @throws std::invalid_argument when a part is covered completely
Sketch character_sketch(const Character& character);

/// Every outline whole, one stroke each, in the order of the parts: outlines cross in full view.
Drawing whole_outlines(const Character& character);

std::vector<Character> animal_characters();
std::vector<Character> people_and_plants();
std::vector<Character> thing_characters();

/// All of the above.
std::vector<Character> all_characters();

// Shapes that parts are made of.
std::vector<Vec2> ellipse(const Vec2& centre, double rx, double ry, double degrees = 0);
std::vector<Vec2> smooth(const std::vector<Vec2>& through);  ///< a loop through points
std::vector<Vec2> limb_outline(const std::vector<Vec2>& through, const std::vector<double>& radii);  ///< round ends
std::vector<Vec2> rounded_polygon(const std::vector<Vec2>& corners, double radius);
std::vector<Vec2> star_outline(const Vec2& centre, int points, double outer,
                               double inner);  ///< with slightly round tips
std::vector<Vec2> cloud_outline(const Vec2& centre, double rx, double ry, int lobes, double bulge);

}  // namespace croquis::test
