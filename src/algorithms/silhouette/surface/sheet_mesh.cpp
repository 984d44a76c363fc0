// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_mesh.h"

#include <algorithm>

namespace croquis::silhouette {
namespace {

/// Of what the front of an attached object lies before that of the one below: so it stays in sight.
constexpr double attached_clearance = 0.25;

/// Per lifted vertex half the least distance from a sheet above and below.
std::vector<SheetClearance> clearance_of_vertices(const InflatedSheets& sheets) {
  std::vector<SheetClearance> clearance(sheets.sampling.lifted.planar_vertex.size());
  for (const StackedPair& pair : sheets.pairs) {
    const double gap = pair.resting ? sheets.resting_gap : sheets.gap;
    const double covered = sheets.front(pair.upper) - sheets.front(pair.lower);
    const double between = sheets.back(pair.upper) - sheets.front(pair.lower) - gap;
    const double half = std::max(pair.attached() ? covered * attached_clearance : between / 2, 0.0);
    double& above = pair.attached() ? clearance[pair.upper].front : clearance[pair.upper].back;
    above = std::min(above, half);
    clearance[pair.lower].front = std::min(clearance[pair.lower].front, half);
  }
  return clearance;
}

}  // namespace

SheetMesh make_sheet_mesh(const InflatedSheets& sheets, const std::vector<Index>& objects) {
  const LiftedTriangulation& lifted = sheets.sampling.lifted;
  SheetMesh mesh;
  mesh.place.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) mesh.place.push_back(sheets.sampling.points[point]);
  mesh.z.assign(sheets.z.begin(), sheets.z.end());
  mesh.thickness.assign(sheets.thickness.begin(), sheets.thickness.end());
  mesh.on_boundary = lifted.on_boundary;
  mesh.triangles = lifted.triangles;
  mesh.neighbours = lifted.neighbours;
  mesh.objects = objects;
  mesh.gap = std::ranges::any_of(sheets.pairs, &StackedPair::resting) ? sheets.resting_gap : sheets.gap;
  const std::vector<SheetClearance> clearance = clearance_of_vertices(sheets);
  for (const auto& [a, b, c] : mesh.triangles)
    mesh.clearance.push_back(common_clearance(common_clearance(clearance[a], clearance[b]), clearance[c]));
  return mesh;
}

std::vector<Shell> object_surfaces(const LabelledFigure& figure, const SheetMesh& sheets) {
  std::vector<Shell> surfaces(figure.objects.size());
  for (Index object = 0; object < surfaces.size(); ++object) {
    Shell& surface = surfaces[object];
    surface.objects = {object};
    std::array copies{std::vector<Index>(sheets.place.size(), no_index),
                      std::vector<Index>(sheets.place.size(), no_index)};
    // The number of a vertex' front or back; on the boundary they are the same.
    const auto copy_of = [&](Index v, bool in_front) {
      in_front |= sheets.on_boundary[v] != 0;
      Index& copy = copies[in_front ? 0 : 1][v];
      if (copy == no_index) {
        copy = static_cast<Index>(surface.mesh.positions.size());
        surface.mesh.positions.emplace_back(sheets.place[v].x(), sheets.place[v].y(),
                                            in_front ? sheets.front(v) : sheets.back(v));
      }
      return copy;
    };
    for (const bool in_front : {true, false}) {
      for (Index m = 0; m < sheets.triangles.size(); ++m) {
        if (sheets.objects[m] != object) continue;
        const auto [a, b, c] = sheets.triangles[m];
        const auto [second, third] = in_front ? std::pair(b, c) : std::pair(c, b);
        surface.mesh.add_triangle(copy_of(a, in_front), copy_of(second, in_front), copy_of(third, in_front));
      }
    }
    surface.euler = closed_euler_number(surface.mesh);
  }
  return surfaces;
}

}  // namespace croquis::silhouette
