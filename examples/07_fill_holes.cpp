// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the holes of a scan, fills all but its base, and says what each patch is worth.
// 07_fill_holes SCAN FILLED.ply
#include <iostream>

#include "croquis/base/error.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"

int main(int argc, char** argv) try {
  using namespace croquis;
  if (argc != 3) return 2;
  Progress progress;
  const PolyMesh scan = read_mesh(read_file(argv[1]), MeshFormat::Ply, argv[1], progress).mesh;

  // The one that should stay open is the largest: what the scan stood on.
  hole_filling::FillOptions options;
  options.selection = hole_filling::Selection::AllButLargest;
  options.threads = 0;
  hole_filling::HoleRequest request;  // hole 1 gets a patch that stands out a little
  request.holes = {1};
  request.bulge = 0.2;
  options.requests.push_back(request);

  const hole_filling::FillResult filled = hole_filling::fill_holes(scan, options, progress);
  for (const hole_filling::Hole& hole : filled.analysis.holes) {
    const hole_filling::HoleOutcome& outcome = filled.outcomes[hole.id];
    std::cout << "hole " << hole.id << ": " << to_string(hole.kind) << ", " << hole.vertices.size() << " edges, "
              << hole.diameter << " wide: ";
    if (outcome.action == hole_filling::FillAction::Fill)
      std::cout << outcome.new_faces << " faces by " << outcome.method << ", confidence " << outcome.confidence << "\n";
    else
      std::cout << "open, " << outcome.reason << "\n";
  }
  for (const Finding& warning : filled.warnings) std::cout << warning.code << ": " << warning.message << "\n";
  std::cout << "the scan's own points and faces are " << (filled.outside_unchanged ? "as they were" : "changed")
            << "\n";

  OutputTransaction output;
  output.add(argv[2], write_mesh(filled.mesh, MeshFormat::Ply, {}, progress).bytes);
  output.commit();
  return filled.outside_unchanged && filled.new_faces > 0 ? 0 : 1;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
