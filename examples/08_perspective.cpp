// SPDX-License-Identifier: GPL-3.0-or-later
// From one drawing in perspective to a solid in a file: 08_perspective DRAWING.svg SOLID.obj
#include <algorithm>
#include <iostream>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"

int main(int argc, char** argv) try {
  using namespace croquis;
  if (argc != 3) return 2;
  Progress progress;
  const PerspectiveDrawing drawing = read_perspective_svg(read_file(argv[1]), argv[1], progress).drawing;

  // The camera and every stroke in space, the faces between the curves, and the surfaces of the faces.
  const ReconstructedNetwork network = reconstruct_network(drawing, {}, progress);
  const FaceFindingResult faces = find_faces(network.curves.network, progress);
  const Solid solid = make_solid(network.curves.network, network.fitted, faces.best, progress);

  const Camera& camera = network.coordinates.camera;
  std::cout << "eye at " << camera.eye.transpose() << ", focal length " << camera.focal_length << " px\n"
            << network.curves.network.curves.size() << " curves, " << solid.brep.faces.size() << " faces\n";
  for (const double volume : solid.tessellation.volume) std::cout << "a shell of volume " << volume << "\n";
  for (const Findings& warnings : {network.warnings, faces.warnings, solid.warnings}) {
    for (const Finding& warning : warnings) std::cout << warning.code << ": " << warning.message << "\n";
  }

  OutputTransaction output;
  output.add(argv[2], write_mesh(solid.tessellation.mesh, MeshFormat::Obj, {}, progress).bytes);
  output.commit();
  return std::ranges::all_of(solid.brep.shells, &BrepShell::closed) ? 0 : 1;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
