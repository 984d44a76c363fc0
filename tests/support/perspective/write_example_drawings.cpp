// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the perspective drawings of examples/data: write_example_drawings FOLDER
#include <fstream>
#include <iostream>
#include <string>

#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

namespace {

using namespace croquis;
using namespace croquis::test;

/// As a careful hand would draw it: ends miss each other by less than a pixel, nobody writes down which ones meet.
SolidDrawingOptions by_hand() {
  SolidDrawingOptions options;
  options.noise = 0.6;
  options.end_jitter = 0.4;
  options.construction_lines = 4;
  options.vertex_ids = false;
  options.hidden = true;
  return options;
}

bool write(const std::string& folder, const std::string& name, const PerspectiveSolid& solid, const View& view) {
  std::ofstream file(folder + "/" + name + ".svg", std::ios::binary);
  file << write_perspective_svg(drawn(solid, view, by_hand()).drawing);
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_example_drawings FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  const bool written = write(folder, "bottle", bottle(), View{}) && write(folder, "camera", camera_body(), View{}) &&
                       write(folder, "soap", soap(), off_centre_view()) &&
                       write(folder, "frame", ring_frame(), View{}) &&
                       write(folder, "bracket", l_block(), level_view());
  if (!written) std::cerr << "can't write into " << folder << '\n';
  return written ? 0 : 1;
}
