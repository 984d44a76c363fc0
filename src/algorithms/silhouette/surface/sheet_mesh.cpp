// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_mesh.h"

#include <algorithm>

namespace croquis::silhouette {
namespace {

/// Of what the front of an attached object lies before that of the one below: so it stays in sight.
constexpr double attached_room = 0.25;

/// Per lifted vertex half the least distance from a sheet above and below.
std::vector<SheetRoom> room_of_vertices(const InflatedSheets& sheets) {
  std::vector<SheetRoom> room(sheets.sampling.lifted.planar_vertex.size());
  for (const StackedPair& pair : sheets.pairs) {
    const double back = sheets.z[pair.upper] - sheets.thickness[pair.upper];
    const double front = sheets.z[pair.lower] + sheets.thickness[pair.lower];
    const double gap = pair.resting ? sheets.resting_gap : sheets.gap;
    const double covered = sheets.z[pair.upper] + sheets.thickness[pair.upper] - front;
    const double half = std::max(pair.attached() ? covered * attached_room : (back - front - gap) / 2, 0.0);
    double& above = pair.attached() ? room[pair.upper].front : room[pair.upper].back;
    above = std::min(above, half);
    room[pair.lower].front = std::min(room[pair.lower].front, half);
  }
  return room;
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
  const bool rests =
      std::any_of(sheets.pairs.begin(), sheets.pairs.end(), [](const auto& pair) { return pair.resting; });
  mesh.gap = rests ? sheets.resting_gap : sheets.gap;
  const std::vector<SheetRoom> room = room_of_vertices(sheets);
  for (const auto& [a, b, c] : mesh.triangles) mesh.room.push_back(common_room(common_room(room[a], room[b]), room[c]));
  return mesh;
}

}  // namespace croquis::silhouette
