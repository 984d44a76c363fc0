// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <deque>
#include <limits>

#include "algorithms/perspective/coordinates/seen_vertices.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {
namespace {

/// The coordinate that both ends of a stroke have in common and along which the ray goes most.
int passed_axis(StrokeGroup group, const Vec3& ray) {
  const int axis = axis_of(group);
  if (!is_parallel(group)) return axis;
  const int one = (axis + 1) % 3;
  const int other = (axis + 2) % 3;
  return std::abs(ray[one]) >= std::abs(ray[other]) ? one : other;
}

}  // namespace

std::vector<Vec3> propagate(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                            const CameraEstimate& camera, std::span<const StrokeGroup> groups, Index from,
                            double first_depth) {
  const TiedVertices tied = tied_vertices(drawing, vertices, camera, groups);
  std::vector<Vec3> positions(vertices.vertices.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  positions[from] = first_depth * tied.seen.ray(from);
  std::deque<Index> queue{from};
  while (!queue.empty()) {
    const Index a = queue.front();
    queue.pop_front();
    for (const StrokeEnd& end : vertices.vertices[a].ends) {
      const Index b = vertices.of_stroke[end.stroke][end.at_end ? 0 : 1];
      if (groups[end.stroke] == StrokeGroup::Unknown || b == no_index || positions[b].allFinite()) continue;
      const Vec3 ray = tied.seen.ray(b);
      const int axis = passed_axis(groups[end.stroke], ray);
      positions[b] = positions[a][axis] / ray[axis] * ray;
      if (positions[b].allFinite()) queue.push_back(b);
    }
  }
  return positions;
}

}  // namespace croquis
