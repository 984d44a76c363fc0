// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/open_sheet.h"

#include <algorithm>

#include "croquis/geometry/mesh_topology.h"

namespace croquis::hole_filling {
namespace {

PolyMesh with_faces(const PolyMesh& mesh, const std::vector<bool>& stays) {
  std::vector<Index> number(mesh.vertex_count(), no_index);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!stays[f]) continue;
    for (const Index v : mesh.face(f)) number[v] = 0;
  }
  PolyMesh kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(kept.vertex_count());
    kept.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (stays[f]) kept.add_triangle(number[face[0]], number[face[1]], number[face[2]]);
  }
  return kept;
}

/// Which faces leave the border simple.
std::vector<bool> faces_that_stay(const PolyMesh& mesh, const MeshTopology& topology) {
  std::vector<bool> stays(mesh.face_count(), true);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    int border_edges = 0;
    for (Index corner = 3 * f; corner < 3 * f + 3; ++corner)
      border_edges += topology.edge_corners(topology.edge(corner)).size() == 1 ? 1 : 0;
    stays[f] = border_edges < 2;
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (topology.fan_count(v) < 2) continue;
    for (const Index corner : topology.vertex_corners(v)) stays[topology.face(corner)] = false;
  }
  return stays;
}

}  // namespace

PolyMesh open_sheet(const PolyMesh& triangles, std::span<const std::uint8_t> left_out) {
  std::vector<bool> stays(triangles.face_count());
  for (std::size_t f = 0; f < stays.size(); ++f)
    stays[f] = std::ranges::none_of(triangles.face(f), [&](Index v) { return left_out[v] != 0; });
  PolyMesh sheet = with_faces(triangles, stays);
  for (;;) {  // each round removes a face at least
    stays = faces_that_stay(sheet, MeshTopology(sheet));
    if (std::find(stays.begin(), stays.end(), false) == stays.end()) return sheet;
    sheet = with_faces(sheet, stays);
  }
}

std::vector<BorderLoop> border_loops(const PolyMesh& sheet) {
  const MeshTopology topology(sheet);
  std::vector<BorderLoop> loops;
  for (std::size_t i = 0; i < topology.boundary_loops().size(); ++i) {
    const auto loop = topology.boundary_loops()[i];
    const Index corner = topology.vertex_corners(loop.front()).front();
    loops.push_back({{loop.begin(), loop.end()}, topology.component(topology.face(corner))});
  }
  return loops;
}

PolyMesh components_of(const PolyMesh& sheet, const std::vector<bool>& wanted) {
  const MeshTopology topology(sheet);
  std::vector<bool> stays(sheet.face_count());
  for (Index f = 0; f < sheet.face_count(); ++f) stays[f] = wanted[topology.component(f)];
  return with_faces(sheet, stays);
}

}  // namespace croquis::hole_filling
