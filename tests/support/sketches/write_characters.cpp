// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the drawings of all characters as SVG files, to look at what becomes of them: write_characters FOLDER
// NAME.svg has exact lines, NAME-hand.svg a hasty hand's, NAME-whole.svg every outline whole.
#include <algorithm>
#include <fstream>
#include <iostream>

#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_modifiers.h"
#include "support/sketches/sketch_svg.h"

namespace {

using namespace croquis;
using namespace croquis::test;

bool write(const std::string& path, const Drawing& drawing) {
  SvgStyle style;
  style.decimals = 2;
  style.shift = true;
  std::ofstream file(path);
  file << to_svg(drawing, style);
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_characters FOLDER\n";
    return 2;
  }
  bool done = true;
  std::uint64_t seed = 1;
  for (const Character& character : all_characters()) {
    std::string name = character.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    const std::string path = std::string(argv[1]) + '/' + name;
    const Drawing drawing = character_sketch(character).drawing;
    done = write(path + ".svg", drawing) && write(path + "-hand.svg", noisy(drawing, seed++)) &&
           write(path + "-whole.svg", whole_outlines(character)) && done;
  }
  if (!done) std::cerr << "a file in " << argv[1] << " could not be written\n";
  return done ? 0 : 1;
}
