// SPDX-License-Identifier: GPL-3.0-or-later
// From an SVG sketch to a solid in a file: 03_inflate_sketch SKETCH.svg SOLID.obj
#include <iostream>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"

int main(int argc, char** argv) try {
  using namespace croquis;
  if (argc != 3) return 2;
  Progress progress;
  const Drawing drawing = read_svg_drawing(read_file(argv[1]), argv[1], progress).drawing;

  const silhouette::Options options;
  const silhouette::LabelledDrawing labelled = silhouette::label(drawing, options, progress);
  const silhouette::Solid solid = silhouette::inflate(labelled, drawing, options, progress);
  for (const silhouette::SolidObject& object : solid.objects) {
    std::cout << object.name << ": Euler number " << object.euler_mesh << "\n";
  }

  OutputTransaction output;
  output.add(argv[2], write_mesh(solid.mesh, MeshFormat::Obj, {}, progress).bytes);
  output.commit();
  return 0;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
