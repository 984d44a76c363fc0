// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// Per triangle its component, or no_index where it doesn't face the viewer.
inline std::vector<Index> surfaces_in_front(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<Index> surfaces(mesh.face_count(), no_index);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto place = [&](std::size_t corner) { return Vec2(mesh.positions[mesh.face(f)[corner]].head<2>()); };
    if (cross(place(1) - place(0), place(2) - place(0)) > 0) surfaces[f] = topology.component(f);
  }
  return surfaces;
}

/// The triangles of a mesh over each place of the drawing.
class SurfaceColumns {
 public:
  /// @param mesh triangles; not owned
  /// @param cell about the length of an edge, > 0
  SurfaceColumns(const PolyMesh& mesh, double cell) : mesh_(mesh), cell_(cell) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto corners = mesh.face(f);
      Vec2 low = xy(corners[0]), high = low;
      for (const Index v : corners) {
        low = low.cwiseMin(xy(v));
        high = high.cwiseMax(xy(v));
      }
      const auto [left, bottom] = cell_of(low);
      const auto [right, top] = cell_of(high);
      for (long x = left; x <= right; ++x) {
        for (long y = bottom; y <= top; ++y) faces_[{x, y}].push_back(f);
      }
    }
  }

  /// Calls visit(face, z, whether it faces the viewer) for every triangle over a place, ascending; those that are seen
  /// from their edge have none.
  /// @param slack barycentric: places so far beyond a triangle's edges count as within it
  template <typename Visit>
  void at(const Vec2& place, double slack, Visit visit) const {
    const auto faces = faces_.find(cell_of(place));
    if (faces == faces_.end()) return;
    for (const Index f : faces->second) {
      const auto corners = mesh_.face(f);
      const Vec2 a = xy(corners[0]), b = xy(corners[1]), c = xy(corners[2]);
      const double area = cross(b - a, c - a);
      if (area == 0) continue;
      const double at_b = cross(place - a, c - a) / area, at_c = cross(b - a, place - a) / area;
      if (at_b < -slack || at_c < -slack || at_b + at_c > 1 + slack) continue;
      visit(f, (1 - at_b - at_c) * z_of(corners[0]) + at_b * z_of(corners[1]) + at_c * z_of(corners[2]), area > 0);
    }
  }

 private:
  Vec2 xy(Index vertex) const { return mesh_.positions[vertex].head<2>(); }
  double z_of(Index vertex) const { return mesh_.positions[vertex].z(); }
  std::pair<long, long> cell_of(const Vec2& place) const {
    return {std::lround(place.x() / cell_), std::lround(place.y() / cell_)};
  }

  const PolyMesh& mesh_;
  double cell_;
  std::map<std::pair<long, long>, std::vector<Index>> faces_;
};

}  // namespace croquis::silhouette
