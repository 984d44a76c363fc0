// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rim_distance.h"

#include <limits>

#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

const Vec2& place_of(const SheetSampling& sheets, Index vertex) {
  return sheets.points[sheets.lifted.planar_vertex[vertex]];
}

double distance_to(const SheetSampling& sheets, const RimEdge& edge, Index vertex) {
  const Vec2 &begin = place_of(sheets, edge.begin), &end = place_of(sheets, edge.end),
             &place = place_of(sheets, vertex);
  return (begin + nearest_parameter(place, begin, end) * (end - begin) - place).norm();
}

}  // namespace

RimDistances rim_distances(const SheetSampling& sheets, double reach) {
  const LiftedTriangulation& lifted = sheets.lifted;
  const std::size_t count = lifted.planar_vertex.size();
  RimDistances rim{{}, std::vector<Index>(count, no_index), {}};
  rim.distance.assign(count, std::numeric_limits<double>::infinity());
  std::vector<Index> leaving(count, no_index), entering(count, no_index);  // edges of the boundary
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[t][corner] != no_index) continue;
      const double radius = sheets.pieces[sheets.planar.constraints[lifted.planar_triangle[t]][corner]].row_radius;
      const auto edge = static_cast<Index>(rim.edges.size());
      const Index begin = lifted.triangles[t][next(corner)], end = lifted.triangles[t][previous(corner)];
      rim.edges.push_back({begin, end, radius, row_depths(radius, sheets.step).front()});
      leaving[begin] = entering[end] = edge;
      rim.nearest[begin] = rim.nearest[end] = edge;
      rim.distance[begin] = rim.distance[end] = 0;
    }
  }
  const auto offer = [&](Index vertex, Index edge) {
    bool taken = false;
    for (const Index candidate : {edge, entering[rim.edges[edge].begin], leaving[rim.edges[edge].end]}) {
      const double distance = distance_to(sheets, rim.edges[candidate], vertex);
      if (distance >= rim.distance[vertex] || distance > reach * rim.edges[candidate].radius) continue;
      rim.distance[vertex] = distance;
      rim.nearest[vertex] = candidate;
      taken = true;
    }
    return taken;
  };
  // Each round reaches at least one ring of vertices further in, until no neighbour knows a nearer edge.
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::array<Index, 3>& corners : lifted.triangles) {
      for (const Index from : corners) {
        const Index edge = rim.nearest[from];
        if (edge == no_index) continue;
        for (const Index to : corners) {
          if (!lifted.on_boundary[to] && rim.nearest[to] != edge && offer(to, edge)) changed = true;
        }
      }
    }
  }
  return rim;
}

double depth_below(const SheetSampling& sheets, const RimEdge& edge, Index vertex) {
  const Vec2& begin = place_of(sheets, edge.begin);
  const Vec2 inward = left_of((place_of(sheets, edge.end) - begin).normalized());
  return (place_of(sheets, vertex) - begin).dot(inward);
}

}  // namespace croquis::silhouette
