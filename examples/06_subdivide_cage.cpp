// SPDX-License-Identifier: GPL-3.0-or-later
// A block with a sharp ring around its top: refined by Doo-Sabin, dragged, and written as OBJ.
// 06_subdivide_cage SURFACE.obj
#include <array>
#include <iostream>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/subdivision/chain_curve.h"
#include "croquis/subdivision/continuity.h"
#include "croquis/subdivision/level_mesh.h"

int main(int argc, char** argv) try {
  using namespace croquis;
  if (argc != 2) return 2;
  PolyMesh block;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) block.positions.emplace_back(x, y, z);
  }
  block.add_face(std::array<Index, 4>{3, 2, 1, 0});
  block.add_face(std::array<Index, 4>{4, 5, 6, 7});
  for (Index i = 0; i < 4; ++i) block.add_face(std::array<Index, 4>{i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4});
  for (Index i = 0; i < 4; ++i) block.tags.creases.push_back({{i + 4, (i + 1) % 4 + 4}, infinite_sharpness});

  // The plan depends on connectivity and tags; it stays while points are dragged.
  Progress progress;
  const subdivision::Rules rules;
  subdivision::Cage cage = subdivision::make_cage(block, rules).cage;
  const subdivision::DooSabinPlan plan(cage, rules, 4, progress);
  subdivision::PositionBuffers points;
  plan.positions(cage.positions, points);
  cage.positions[4].z() = 1.5;
  plan.positions(cage.positions, points);

  const auto curves = subdivision::limit_curves(plan, points, rules);
  std::cout << plan.level(4).topology.face_count() << " faces; the ring is a B-spline of "
            << curves[0].control_points.size() << " control points, sampled by "
            << subdivision::sampled(curves[0], 1e-3).size() << " points; "
            << subdivision::continuity_report(plan, points, progress).sentence << "\n";

  const PolyMesh surface = subdivision::to_mesh(plan.level(4), points.levels[4]);
  OutputTransaction output;
  output.add(argv[1], write_mesh(surface, MeshFormat::Obj, {}, progress).bytes);
  output.commit();
  return curves.size() == 1 && curves[0].exact ? 0 : 1;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
