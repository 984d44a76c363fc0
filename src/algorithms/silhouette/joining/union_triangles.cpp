// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/union_triangles.h"

#include <algorithm>

#include "algorithms/silhouette/surface/triangle_shape.h"

namespace croquis::silhouette {
UnionTriangles::UnionTriangles(const Shell& joined)
    : positions_(joined.mesh.positions), changed_(joined.mesh.face_count(), 0), stars_(joined.mesh.vertex_count()) {
  for (Index f = 0; f < joined.mesh.face_count(); ++f) {
    const auto c = joined.mesh.face(f);
    triangles_.push_back({{c[0], c[1], c[2]}, 2 * joined.face_objects[f] + (seen_area(joined.mesh, f) > 0 ? 1 : 0)});
    for (const Index v : c) stars_[v].push_back(f);
  }
}

std::vector<Spoke> UnionTriangles::spokes(Index v) const {
  std::vector<Spoke> found;
  for (const Index left : stars_[v]) {
    const Index to = corners(left)[(corner_of(corners(left), v) + 1) % 3];
    for (const Index right : stars_[v]) {
      if (corners(right)[(corner_of(corners(right), v) + 2) % 3] == to) found.push_back({to, left, right});
    }
  }
  return found;
}

bool UnionTriangles::joins(Index a, Index b) const {
  return std::any_of(stars_[a].begin(), stars_[a].end(), [&](Index t) { return has_corner(corners(t), b); });
}

Index UnionTriangles::beyond(Index t, std::size_t corner) const {
  const Index from = corners(t)[(corner + 2) % 3];
  const Index to = corners(t)[(corner + 1) % 3];
  for (const Index other : stars_[from]) {
    if (corners(other)[(corner_of(corners(other), from) + 1) % 3] == to) return other;
  }
  return no_index;
}

std::vector<Index> UnionTriangles::apply(const Exchange& exchange) {
  for (const Index t : exchange.removed) {
    for (const Index v : triangles_[t].corners) std::erase(stars_[v], t);
    triangles_[t].corners.fill(no_index);
  }
  if (exchange.moved != no_index) positions_[exchange.moved] = exchange.place;
  std::vector<Index> added;
  for (const SidedTriangle& triangle : exchange.added) {
    const Index t = exchange.removed[added.size()];
    triangles_[t] = triangle;
    changed_[t] = 1;
    for (const Index v : triangle.corners) stars_[v].push_back(t);
    added.push_back(t);
  }
  return added;
}

std::vector<Index> UnionTriangles::written_vertices() const {
  std::vector<Index> used;
  for (Index v = 0; v < positions_.size(); ++v) {
    if (!stars_[v].empty()) used.push_back(v);
  }
  return used;
}

std::vector<Index> UnionTriangles::write(Shell& joined) const {
  std::vector<Index> number(positions_.size(), no_index);
  Shell written{{}, joined.objects, {}, joined.euler, joined.blends};
  for (const Index v : written_vertices()) {
    number[v] = static_cast<Index>(written.mesh.positions.size());
    written.mesh.positions.push_back(positions_[v]);
  }
  std::vector<Index> changed;
  for (Index t = 0; t < triangles_.size(); ++t) {
    if (is_dead(t)) continue;
    if (changed_[t]) changed.push_back(static_cast<Index>(written.face_objects.size()));
    written.mesh.add_triangle(number[corners(t)[0]], number[corners(t)[1]], number[corners(t)[2]]);
    written.face_objects.push_back(side(t) / 2);
  }
  joined = std::move(written);
  return changed;
}

}  // namespace croquis::silhouette
