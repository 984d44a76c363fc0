// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the sketches of examples/data that are generated: write_example_sketches FOLDER
#include <fstream>
#include <iostream>
#include <utility>

#include "support/sketches/sketch_generator.h"

namespace {

using namespace croquis;
using namespace croquis::test;

/// A name for a stroke that says which part of what it belongs to: "ring-2-a", "ring-2-b".
void name_strokes(Drawing& drawing, const std::string& name) {
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    drawing.strokes[i].id = name + '-' + std::to_string(i + 1);
  }
}

bool write(const std::string& folder, const std::string& name, const std::string& part, Drawing drawing) {
  name_strokes(drawing, part);
  SvgStyle style;
  style.curves = SvgCurves::Cubic;
  style.decimals = 2;
  style.tolerance = 0.1;
  style.shift = true;
  std::ofstream file(folder + '/' + name + ".svg");
  file << to_svg(drawing, style);
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_example_sketches FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  bool done = true;
  const auto add = [&](const std::string& name, const std::string& part, const Sketch& sketch) {
    done = write(folder, name, part, sketch.drawing) && done;
  };
  add("trefoil", "tube", trefoil_sketch());
  add("snake", "snake", snake_sketch());
  add("ring_and_bar", "line", ring_and_bar_sketch());
  add("linked_rings", "ring", linked_rings_sketch());
  add("borromean", "ring", borromean_sketch());
  add("chain", "link", chain_sketch());
  add("weave", "bar", weave_sketch());
  add("knot_3_4", "tube", torus_knot_sketch(3, 4));
  add("dog", "dog", dog_sketch());
  add("duck", "duck", duck_sketch());
  add("octopus", "octopus", octopus_sketch());
  done = write(folder, "noisy_trefoil", "pen", noisy(trefoil_sketch().drawing, 4)) && done;
  if (!done) std::cerr << "a file in " << folder << " could not be written\n";
  return done ? 0 : 1;
}
